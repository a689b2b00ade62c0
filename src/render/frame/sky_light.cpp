#include "skydrop/render/frame/sky_light.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "skydrop/render/frame/sky_clock.h"
#include "skydrop/sky/almanac.h"
#include "skydrop/sky/refraction.h"

namespace skydrop::render {
namespace {

// Exposure brings a grey card (18 %) in the sun at noon to 0.45, which the tone map shows as grey, and
// follows the light of other hours only partly: an eye that adapted fully would see no evening.
constexpr double kNoonExposure = 0.08;  // where the level is kNoonLevel
constexpr double kNoonLevel = 140;      // klx
constexpr double kAdaptation = 0.82;    // exponent: 1 adapts fully
constexpr double kDarkestLevel = 5e-3;  // klx, below which the eye adapts no further

double luminance(const glm::dvec3& light) { return glm::dot(light, glm::dvec3(0.2126, 0.7152, 0.0722)); }

}  // namespace

glm::dvec3 directionToSun(const SunSettings& sun, double simulatedSeconds) {
  if (sun.source == SunSource::clock) {
    const sky::Body body = sky::sunAt(clockDays(sun, simulatedSeconds), placeOf(sun));
    return sky::worldDirection(sky::refracted(body.horizontal));
  }
  return sky::directionToSun(sun.elevationDegrees, sun.azimuthDegrees);
}

sky::Atmosphere atmosphereOf(const AtmosphereSettings& settings) {
  return sky::makeAtmosphere(settings.visibilityM, settings.hazeHeightM, settings.hazeAnisotropy);
}

SkyLight skyLight(const RenderSettings& settings, double eyeHeight, double simulatedSeconds) {
  SkyLight light{sky::skyLight(atmosphereOf(settings.atmosphere),
                               directionToSun(settings.sun, simulatedSeconds), eyeHeight,
                               settings.sky.model)};
  const glm::dvec3 level = light.sun * std::max(light.toSun.y, 0.0) + light.sky;
  // A low sun lights the horizon more than the land, and the horizon is what fills the picture.
  const double seen = luminance(level + std::numbers::pi * meanHorizonRadiance(light));
  light.exposure = kNoonExposure * std::pow(kNoonLevel / std::max(seen, kDarkestLevel), kAdaptation) *
                   std::exp2(settings.exposureStops);
  return light;
}

}  // namespace skydrop::render
