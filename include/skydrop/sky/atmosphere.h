// The atmosphere on the CPU: what the sun, the sky and the haze send to an eye, without OpenGL. This header
// and shaders/sky/atmosphere.glsl are all that the rest of the program knows of the model; today that is the
// closed form of shaders/shared/atmosphere.glsl, whose functions both call.
//
// Pure functions, from any thread. Light is in kilolux and kilocandela per square metre (linear sRGB
// primaries), heights in metres above the sea (any finite value), directions are unit vectors (x east, y up,
// z south).
#pragma once

#include <glm/vec3.hpp>

#include "skydrop/core/shared.h"

namespace skydrop::sky {

using core::shared::f64::Atmosphere;
using core::shared::f64::SkyColumn;
using core::shared::f64::SkySource;

// Angular radius of the sun's disc: 0.267 degrees.
inline constexpr double kSunRadiusRad = core::shared::f64::kSunRadius;

// Compass azimuth and elevation above the horizon, any angles.
glm::dvec3 directionToSun(double elevationDegrees, double azimuthDegrees);

// visibilityM: where contrast falls to 2 % at sea level, > 0; hazeHeightM: scale height of the aerosol, > 0;
// hazeAnisotropy: of its phase function, [-0.95, 0.95].
Atmosphere makeAtmosphere(double visibilityM, double hazeHeightM, double hazeAnisotropy);

// The light at a height.
struct SkyLight {
  glm::dvec3 toSun{0, 1, 0};
  Atmosphere air{};
  glm::dvec3 sunOutside{0};  // illuminance of the sun above the atmosphere
  glm::dvec3 sun{0};         // here, on a surface that faces it; 0 below the horizon
  glm::dvec3 sky{0};         // on a horizontal surface, from the sky alone
  glm::dvec3 ground{0};      // on a surface that faces down, from average land
  glm::dvec3 night{0};       // radiance of the sky without any sun
  SkyColumn column{};        // the air above
  SkySource horizon{};       // the sky at the horizon
};

SkyLight skyLight(const Atmosphere& air, const glm::dvec3& toSun, double heightM);

// Radiance of the sky in a direction, the night's included, without the sun's disc; below the horizon that of
// the horizon.
glm::dvec3 skyRadiance(const SkyLight& light, const glm::dvec3& direction);
// Radiance of the sky at the horizon, by the cosine between it and the sun: what haze sends towards the eye.
glm::dvec3 horizonRadiance(const SkyLight& light, double cosSunAngle);
// The mean of it over all directions, without the night's.
glm::dvec3 meanHorizonRadiance(const SkyLight& light);
// Radiance of the sun's disc.
glm::dvec3 sunDiscRadiance(const SkyLight& light);

// Illuminance by the sun at a height, on a surface that faces it.
glm::dvec3 sunIlluminance(const SkyLight& light, double heightM);

// Optical depth and transmittance of a straight path between two heights, of a length >= their difference.
glm::dvec3 opticalDepth(const Atmosphere& air, double fromHeightM, double toHeightM, double lengthM);
glm::dvec3 transmittance(const Atmosphere& air, double fromHeightM, double toHeightM, double lengthM);

// A radiance as it reaches the eye, at eyeHeightM, from a place `relative` to it (m, world axes; length 0: as
// it is): what the air leaves of it, and the light of the air between, which is that of the horizon. As
// applyAerialPerspective of shaders/sky/atmosphere.glsl with HAZE. `light`: of the eye's height.
glm::dvec3 applyAerialPerspective(const SkyLight& light, const glm::dvec3& radiance, double eyeHeightM,
                                  const glm::dvec3& relative);

}  // namespace skydrop::sky
