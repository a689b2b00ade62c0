#include "skydrop/render/frame/sky_light.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

namespace skydrop::render {
namespace {

namespace shared = core::shared::f64;

// The sun above the atmosphere: 128 klx (1361 W/m^2 at 94 lm/W), a little warmer than sRGB's white.
constexpr glm::dvec3 kSunOutside = 128.0 * glm::dvec3(1.04, 0.99, 0.95);

// Rayleigh scattering at sea level for sRGB's primaries, 1/m, and its scale height (Bruneton 2017 after
// Penndorf 1957).
constexpr glm::dvec3 kRayleigh(5.802e-6, 13.558e-6, 33.1e-6);
constexpr double kRayleighHeight = 8000;
constexpr double kHazeAlbedo = 0.94;  // continental aerosol (Shettle and Fenn 1979: 0.9 to 0.96)

// The night sky of the game: brighter than starlight (2e-7 kcd/m^2) by far, so that land can be made out.
constexpr glm::dvec3 kNightRadiance = 4e-4 * glm::dvec3(0.55, 0.75, 1.3);

// Average land and sea, for light from below.
constexpr double kGroundAlbedo = 0.12;

// Exposure brings a grey card (18 %) in the sun at noon to 0.45, which the tone map shows as grey, and
// follows the light of other hours only partly: an eye that adapted fully would see no evening.
constexpr double kNoonExposure = 0.08;  // where the level is kNoonLevel
constexpr double kNoonLevel = 140;      // klx
constexpr double kAdaptation = 0.82;    // exponent: 1 adapts fully
constexpr double kDarkestLevel = 5e-3;  // klx, below which the eye adapts no further

double luminance(const glm::dvec3& light) { return glm::dot(light, glm::dvec3(0.2126, 0.7152, 0.0722)); }

// Illuminance on a horizontal surface by the sky: a sum over the hemisphere, rings of equal projected solid
// angle.
glm::dvec3 skyIlluminance(const SkyLight& light) {
  constexpr int kRings = 8, kSectors = 12;
  glm::dvec3 sum(0);
  for (int ring = 0; ring < kRings; ++ring) {
    const double sine = std::sqrt((ring + 0.5) / kRings), cosine = std::sqrt(1 - sine * sine);
    for (int sector = 0; sector < kSectors; ++sector) {
      const double angle = 2 * std::numbers::pi * (sector + 0.5) / kSectors;
      sum += skyRadiance(light, {sine * std::cos(angle), cosine, sine * std::sin(angle)});
    }
  }
  return sum * (std::numbers::pi / (kRings * kSectors));
}

}  // namespace

glm::dvec3 directionToSun(const SunSettings& sun) {
  const double elevation = glm::radians(sun.elevationDegrees), azimuth = glm::radians(sun.azimuthDegrees);
  return {std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
          -std::cos(azimuth) * std::cos(elevation)};
}

shared::Atmosphere atmosphereOf(const AtmosphereSettings& settings) {
  shared::Atmosphere air{};
  air.rayleigh = kRayleigh;
  air.rayleighHeight = kRayleighHeight;
  // Koschmieder (1924): contrast falls to 2 % over 3.912 extinction lengths. What clean air does not
  // extinguish (green, where the eye judges) is haze.
  air.haze = std::max(3.912 / settings.visibilityM - kRayleigh.y, 0.0);
  air.hazeHeight = settings.hazeHeightM;
  air.hazeAlbedo = kHazeAlbedo;
  air.hazeAnisotropy = settings.hazeAnisotropy;
  return air;
}

glm::dvec3 skyRadiance(const SkyLight& light, const glm::dvec3& direction) {
  const shared::SkySource source = shared::skySource(light.column, light.air, direction.y);
  return shared::skyRadiance(source, glm::dot(direction, light.toSun), light.air.hazeAnisotropy) *
             light.sunOutside +
         light.night;
}

glm::dvec3 sunDiscRadiance(const SkyLight& light) {
  return light.sun / (std::numbers::pi * kSunRadiusRad * kSunRadiusRad);
}

SkyLight skyLight(const RenderSettings& settings, double eyeHeight) {
  SkyLight light;
  light.toSun = directionToSun(settings.sun);
  light.air = atmosphereOf(settings.atmosphere);
  light.sunOutside = kSunOutside;
  light.night = kNightRadiance;
  light.sun = kSunOutside * shared::sunTransmittance(light.air, eyeHeight, light.toSun.y) *
              shared::sunVisibleShare(light.toSun.y);
  light.column = shared::make_skyColumn(light.air, eyeHeight, light.toSun.y);
  light.sky = skyIlluminance(light);
  light.horizon = shared::skySource(light.column, light.air, 0);
  const glm::dvec3 level = light.sun * std::max(light.toSun.y, 0.0) + light.sky;
  light.ground = level * kGroundAlbedo;
  // A low sun lights the horizon more than the land, and the horizon is what fills the picture.
  const glm::dvec3 horizon =
      (light.horizon.rayleigh + light.horizon.haze) / (4 * std::numbers::pi) + light.horizon.isotropic;
  const double seen = luminance(level + std::numbers::pi * horizon * light.sunOutside);
  light.exposure = kNoonExposure * std::pow(kNoonLevel / std::max(seen, kDarkestLevel), kAdaptation) *
                   std::exp2(settings.exposureStops);
  return light;
}

}  // namespace skydrop::render
