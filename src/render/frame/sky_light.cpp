#include "skydrop/render/frame/sky_light.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "render/frame/moon_view.h"
#include "skydrop/core/shared.h"
#include "skydrop/render/frame/sky_clock.h"
#include "skydrop/sky/almanac.h"
#include "skydrop/sky/night_light.h"
#include "skydrop/sky/refraction.h"

namespace skydrop::render {
namespace {

// Exposure brings a grey card (18 %) in the sun at noon to 0.45, which the tone map shows as grey, and
// follows the light of other hours only partly: an eye that adapted fully would see no evening.
constexpr double kNoonExposure = 0.08;  // where the level is kNoonLevel
constexpr double kNoonLevel = 140;      // klx
constexpr double kAdaptation = 0.82;    // exponent: 1 adapts fully
constexpr double kDarkestLevel = 3e-6;  // klx, below which the eye adapts no further

// Of moonlight against sunlight: it is a little redder (Ciocca and Wang 2013).
constexpr glm::dvec3 kMoonTint(1.04, 1.0, 0.93);

double luminance(const glm::dvec3& light) { return glm::dot(light, glm::dvec3(0.2126, 0.7152, 0.0722)); }

// So many times the sun's light of the sky must be the moon's for the sun's share of it to lose its
// direction, to have lost it, and for the moon's to have its own. By then the sun is 13 to 16 degrees below
// the horizon under a full moon, and what is left of its glow is no brighter than the moonlit sky around it.
constexpr double kSunFades = 1.5, kSunFaded = 6, kMoonGlows = 24;

// 0 below `from`, 1 above `to`, by the logarithm.
double riseBetween(double x, double from, double to) {
  const double t = std::clamp(std::log(x / from) / std::log(to / from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

// `ofSun`: illuminance by what the air scatters of the sun's light.
void shareGlow(SkyLight& light, const glm::dvec3& ofSun) {
  const double times =
      std::clamp(luminance(light.moon->illuminance) / std::max(luminance(ofSun), 1e-30), 1e-6, 1e6);
  light.sunGlow = 1 - riseBetween(times, kSunFades, kSunFaded);
  light.moonGlow = riseBetween(times, kSunFaded, kMoonGlows);
}

bool isAtNight(const SunSettings& sun, double sine) { return sun.source == SunSource::clock && sine < 0; }

void addMoon(SkyLight& light, const MoonView& moon, sky::SkyModel model, const sky::SkyViews::Place* tables) {
  if (moon.direction.y <= core::shared::f64::horizonSine(std::max(light.heightM, 0.0)) - moon.radiusRad)
    return;
  sky::SkyLight there = sky::skyLight(light.air, moon.direction, light.heightM, model, tables);
  const double share =
      sky::moonIlluminance(moon.phaseAngleDegrees, moon.distanceKm) / luminance(there.sunOutside);
  const glm::dvec3 scale = share * kMoonTint;
  const glm::dvec3 ofSky = (there.sky - std::numbers::pi * there.night) * scale;
  there.sunOutside *= scale;
  there.sun *= scale;
  light.moon = MoonSky{moon.direction, there.view, there.sunOutside, ofSky};
  if (light.isShell()) shareGlow(light, light.sky - std::numbers::pi * light.night);
  light.sky += ofSky;
  light.ground += (there.sun * std::max(moon.direction.y, 0.0) + ofSky) * core::shared::f64::kGroundAlbedo;
  if (luminance(there.sun) <= luminance(light.sun)) return;
  light.direct = there;
  light.directRadiusRad = moon.radiusRad;
}

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

SkyLight skyLight(const RenderSettings& settings, double eyeHeight, double simulatedSeconds,
                  std::optional<double> adaptedLevel, const Overcast& overcast, const SkyPlaces* tables,
                  MoonOfFrame* moon) {
  SkyLight light{sky::skyLight(atmosphereOf(settings.atmosphere),
                               directionToSun(settings.sun, simulatedSeconds), eyeHeight, settings.sky.model,
                               tables ? &tables->sun : nullptr)};
  light.direct = light;
  const bool lacksMoon = tables && !tables->moon;  // while its tables are being made
  if (isAtNight(settings.sun, light.toSun.y) && !lacksMoon) {
    addMoon(light, moonOf(moon, settings.sun, simulatedSeconds), settings.sky.model,
            tables ? &*tables->moon : nullptr);
  }
  const glm::dvec3 level = light.direct.sun * std::max(light.direct.toSun.y, 0.0) + light.sky;
  // A low sun lights the horizon more than the land, and the horizon is what fills the picture.
  glm::dvec3 horizon = std::numbers::pi * meanHorizonRadiance(light);
  if (light.moon) horizon += light.moon->illuminance;
  light.overcast = overcast;
  light.level = std::max(luminance(level + horizon) * overcast.light(), kDarkestLevel);
  const bool isAdapted = adaptedLevel && std::isfinite(*adaptedLevel) && *adaptedLevel > 0;
  const double seen = isAdapted ? std::max(*adaptedLevel, kDarkestLevel) : light.level;
  light.adaptation = kNoonExposure * std::pow(kNoonLevel / seen, kAdaptation);
  light.exposure = light.adaptation * std::exp2(settings.exposureStops);
  return light;
}

// The closed form has moonlight in the air as an even part of the sky: nothing that shade could take from it.
double lightOverNight(const SkyLight& light) {
  if (light.moon && !light.isShell() && light.direct.toSun == light.moon->toMoon) return 0;
  return luminance(light.direct.sun) / (std::numbers::pi * luminance(light.night));
}

SkyPlaces skyPlaces(const RenderSettings& settings, double eyeHeight, double simulatedSeconds,
                    MoonOfFrame* moon) {
  SkyPlaces places{{eyeHeight, directionToSun(settings.sun, simulatedSeconds).y}};
  if (isAtNight(settings.sun, places.sun.sine))
    places.moon = {eyeHeight, moonOf(moon, settings.sun, simulatedSeconds).direction.y};
  return places;
}

}  // namespace skydrop::render
