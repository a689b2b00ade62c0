// The light of a frame: that of the atmosphere (skydrop/sky/atmosphere.h) at the eye's height, and the
// exposure that follows from it. Pure functions of the settings, the height and the simulated time. Light is
// in kilolux and kilocandela per square metre (linear sRGB primaries) before exposure.
#pragma once

#include <glm/vec3.hpp>

#include "skydrop/render/frame/render_settings.h"
#include "skydrop/sky/atmosphere.h"

namespace skydrop::render {

using sky::kSunRadiusRad;

struct SkyLight : sky::SkyLight {
  double exposure = 1;  // what all light is multiplied by before it meets a half-float target
};

// The one place that decides where the sun stands: the two angles of the settings, or, with SunSource::clock,
// where the almanac has it at their place and time (its apparent place: refraction raises it near the
// horizon).
glm::dvec3 directionToSun(const SunSettings& sun, double simulatedSeconds = 0);
sky::Atmosphere atmosphereOf(const AtmosphereSettings& settings);
// eyeHeight in m above the sea, any finite value.
SkyLight skyLight(const RenderSettings& settings, double eyeHeight, double simulatedSeconds = 0);

}  // namespace skydrop::render
