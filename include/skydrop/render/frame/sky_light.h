// The light of a frame: that of the atmosphere (skydrop/sky/atmosphere.h) at the eye's height, and the
// exposure that follows from it. Pure functions of the settings, the height and the simulated time. Light is
// in kilolux and kilocandela per square metre (linear sRGB primaries) before exposure.
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <optional>

#include "skydrop/render/frame/render_settings.h"
#include "skydrop/sky/atmosphere.h"

namespace skydrop::render {

using sky::kSunRadiusRad;

// What the moon adds to the light of the sky. Its own direction in the sky is left out: it is the same
// towards all azimuths.
struct MoonSky {
  std::shared_ptr<const sky::SkyView> view;  // from this height, under this moon; null with the closed form
  glm::dvec3 outside{0};                     // illuminance of the moon above the atmosphere
  glm::dvec3 illuminance{0};                 // on a horizontal surface, from the sky
};

// The light of the sun and its sky, and what else there is. `sky` and `ground` are of all of it.
struct SkyLight : sky::SkyLight {
  // What casts shadows: the sun, or the moon where the clock has one up that is brighter. Of its members
  // `toSun`, `sunOutside` and `sun` are its own (sky::sunIlluminance() of it is that of this light); nothing
  // else is used.
  sky::SkyLight direct{};
  double directRadiusRad = kSunRadiusRad;
  std::optional<MoonSky> moon{};  // after sunset, with the moon above the horizon
  // What exposure follows: illuminance of level ground and of the horizon together, klx, no less than what
  // the eye adapts to at most.
  double level = 0;
  double adaptation = 1;  // the exposure that follows from the light alone
  double exposure = 1;    // with the stops of the settings: what all light is multiplied by before it meets a
                          // half-float target
};

// The one place that decides where the sun stands: the two angles of the settings, or, with SunSource::clock,
// where the almanac has it at their place and time (its apparent place: refraction raises it near the
// horizon).
glm::dvec3 directionToSun(const SunSettings& sun, double simulatedSeconds = 0);
sky::Atmosphere atmosphereOf(const AtmosphereSettings& settings);
// eyeHeight in m above the sea, any finite value. adaptedLevel: what the eye is adapted to (EyeAdaptation),
// as SkyLight::level; without it, or where it is no number above 0, that of this light.
SkyLight skyLight(const RenderSettings& settings, double eyeHeight, double simulatedSeconds = 0,
                  std::optional<double> adaptedLevel = std::nullopt);

}  // namespace skydrop::render
