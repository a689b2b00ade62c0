// The atmosphere on the CPU: what the sun, the sky and the haze send to an eye, without OpenGL. This header
// and shaders/sky/atmosphere.glsl are all that the rest of the program knows of the model. There are two: the
// closed form of shaders/shared/atmosphere.glsl, and the shell of shaders/shared/atmosphere_shell.glsl with
// its tables (sky_view.h).
//
// Pure functions, from any thread. Light is in kilolux and kilocandela per square metre (linear sRGB
// primaries), heights in metres above the sea (any finite value), directions are unit vectors (x east, y up,
// z south).
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <memory>
#include <string_view>

#include "skydrop/core/shared.h"
#include "skydrop/sky/sky_views.h"

namespace skydrop::sky {

using core::shared::f64::SkyColumn;
using core::shared::f64::SkySource;

// Angular radius of the sun's disc: 0.267 degrees.
inline constexpr double kSunRadiusRad = core::shared::f64::kSunRadius;

// Compass azimuth and elevation above the horizon, any angles.
glm::dvec3 directionToSun(double elevationDegrees, double azimuthDegrees);

// visibilityM: where contrast falls to 2 % at sea level, > 0; hazeHeightM: scale height of the aerosol, > 0;
// hazeAnisotropy: of its phase function, [-0.95, 0.95].
Atmosphere makeAtmosphere(double visibilityM, double hazeHeightM, double hazeAnisotropy);

enum class SkyModel {
  closedForm,  // flat layers; costs a frame nothing
  shell        // a spherical shell with many scatterings, by tables
};
inline constexpr std::array<std::string_view, 2> kSkyModelNames = {"closedForm", "shell"};

// The light at a height.
struct SkyLight {
  glm::dvec3 toSun{0, 1, 0};
  double heightM = 0;
  Atmosphere air{};
  glm::dvec3 sunOutside{0};  // illuminance of the sun above the atmosphere
  glm::dvec3 sun{0};         // here, on a surface that faces it; 0 below the horizon
  glm::dvec3 sky{0};         // on a horizontal surface, from the sky alone
  glm::dvec3 ground{0};      // on a surface that faces down, from average land
  glm::dvec3 night{0};       // radiance of the sky without any sun
  SkyColumn column{};        // of the closed form: the air above
  SkySource horizon{};       // of the closed form: the sky at the horizon
  // Of the shell; null with the closed form.
  std::shared_ptr<SkyViews> views{};
  std::shared_ptr<const SkyView> view{};  // from this height, under this sun

  bool isShell() const { return view != nullptr; }
};

// With the shell: the first call for an air makes its tables (about 70 ms), and calls for other heights or
// suns may make some of the sky's (SkyViews::view). tables: where those belong that are looked up; null:
// here.
SkyLight skyLight(const Atmosphere& air, const glm::dvec3& toSun, double heightM,
                  SkyModel model = SkyModel::shell, const SkyViews::Place* tables = nullptr);

// Radiance of the sky in a direction, the night's included, without the sun's disc. Below the horizon: with
// the closed form that of the horizon, with the shell that of the air before the ground.
glm::dvec3 skyRadiance(const SkyLight& light, const glm::dvec3& direction);
// What air of any opacity sends towards the eye from a direction, up to a distance (m, >= 0, or infinite), is
// its opacity times this radiance: with the closed form that of the horizon, with the shell the mean along
// the ray.
glm::dvec3 airRadiance(const SkyLight& light, const glm::dvec3& direction, double distanceM);
// The mean radiance of the level sky over all azimuths (closed form: over all angles to the sun), without the
// night's.
glm::dvec3 meanHorizonRadiance(const SkyLight& light);
// Radiance of the sun's disc; with the shell, of the part of it above the horizon.
glm::dvec3 sunDiscRadiance(const SkyLight& light);

// Illuminance by the sun at a height, on a surface that faces it. With the shell high places see it longer.
glm::dvec3 sunIlluminance(const SkyLight& light, double heightM);

// Optical depth and transmittance of a straight path between two heights, of a length >= their difference.
glm::dvec3 opticalDepth(const Atmosphere& air, double fromHeightM, double toHeightM, double lengthM);
glm::dvec3 transmittance(const Atmosphere& air, double fromHeightM, double toHeightM, double lengthM);

// A radiance as it reaches the eye, at eyeHeightM, from a place `relative` to it (m, world axes; length 0: as
// it is): what the air leaves of it, and the light of the air between (airRadiance). As
// applyAerialPerspective of shaders/sky/atmosphere.glsl with HAZE. `light`: of the eye's height.
glm::dvec3 applyAerialPerspective(const SkyLight& light, const glm::dvec3& radiance, double eyeHeightM,
                                  const glm::dvec3& relative);

}  // namespace skydrop::sky
