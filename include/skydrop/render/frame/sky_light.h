// The light of a frame: sun, sky and haze as seen from the eye's height, from shaders/shared/atmosphere.glsl.
// Pure functions of the settings and the height. Light is in kilolux and kilocandela per square metre (linear
// sRGB primaries) before exposure.
#pragma once

#include <glm/vec3.hpp>

#include "skydrop/core/shared.h"
#include "skydrop/render/frame/render_settings.h"

namespace skydrop::render {

struct SkyLight {
  glm::dvec3 toSun{0, 1, 0};  // unit
  core::shared::f64::Atmosphere air{};
  double exposure = 1;       // what all light is multiplied by before it meets a half-float target
  glm::dvec3 sunOutside{0};  // illuminance of the sun above the atmosphere
  glm::dvec3 sun{0};         // at the eye's height, on a surface that faces it; 0 below the horizon
  glm::dvec3 sky{0};         // on a horizontal surface, from the sky alone
  glm::dvec3 ground{0};      // on a surface that faces down, from average land
  glm::dvec3 night{0};       // radiance of the sky without any sun
  core::shared::f64::SkyColumn column{};   // the air above the eye
  core::shared::f64::SkySource horizon{};  // the sky at the horizon, seen from the eye's height
};

// Compass azimuth and elevation to a unit vector. The sun's light is whitish: about 5800 K against sRGB's
// 6500 K.
glm::dvec3 directionToSun(const SunSettings& sun);
core::shared::f64::Atmosphere atmosphereOf(const AtmosphereSettings& settings);
// eyeHeight in m above the sea, any finite value.
SkyLight skyLight(const RenderSettings& settings, double eyeHeight);
// Radiance of the sky in a unit direction, without the sun's disc; below the horizon that of the horizon.
glm::dvec3 skyRadiance(const SkyLight& light, const glm::dvec3& direction);
// Radiance of the sun's disc, angular radius kSunRadiusRad.
glm::dvec3 sunDiscRadiance(const SkyLight& light);
inline constexpr double kSunRadiusRad = 0.00466;  // 0.267 degrees: the mean over the year

}  // namespace skydrop::render
