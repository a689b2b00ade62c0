#include "skydrop/weather/weather_settings.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "skydrop/core/angles.h"
#include "skydrop/core/error.h"
#include "skydrop/core/hash.h"
#include "weather/site_weather.h"

namespace skydrop::weather {
namespace {

// How far things wander at a variability of 1.
constexpr double kSpeedWander = 0.4;          // of the wind's speed
constexpr double kDirectionWanderDeg = 40;    // of its direction
constexpr double kCoverWander = 0.25;         // of a layer's cover, at half cover
constexpr double kPrecipitationWander = 0.6;  // of precipitation

// What wanders has a stream of its own each.
enum Stream : std::uint64_t { kOfSpeed, kOfDirection, kOfRain, kOfLayers };

// Smooth noise over time in [-1, 1], of twice continuous slope: hashed values at whole knots, and a quintic
// between them (Perlin 2002).
double wander(std::uint64_t seed, std::uint64_t stream, double time) {
  const double knot = std::floor(time), t = time - knot;
  const auto at = [&](double k) {
    core::RandomStream random{core::hashCombine(core::hashCombine(seed, 0x77656174686572ull), stream),
                              static_cast<std::uint64_t>(static_cast<std::int64_t>(k))};
    return 2 * random.nextUnit() - 1;
  };
  const double smooth = t * t * t * (t * (t * 6 - 15) + 10);
  const double a = at(knot), b = at(knot + 1);
  return a + (b - a) * smooth;
}

double smoothShare(double t) {
  const double x = std::clamp(t, 0.0, 1.0);
  return x * x * (3 - 2 * x);
}

void turnAndScale(State& s, double variability, std::uint64_t seed, double time) {
  const double speed = 1 + kSpeedWander * variability * wander(seed, kOfSpeed, time);
  const double turn = kDirectionWanderDeg * variability * wander(seed, kOfDirection, time);
  const auto moved = [&](double& speedMps, double& directionDeg) {
    speedMps *= speed;
    directionDeg = core::wrappedDegrees(directionDeg + turn);
  };
  moved(s.wind.speedMps, s.wind.directionDeg);
  for (WindLevel& level : s.wind.levels) moved(level.speedMps, level.directionDeg);
  for (std::size_t i = 0; i < kLayers; ++i) {
    double& cover = s.layers[i].cover;  // none and all of the sky stay what they are
    cover = std::clamp(
        cover + kCoverWander * variability * 4 * cover * (1 - cover) * wander(seed, kOfLayers + i, time), 0.0,
        1.0);
  }
  const double wetter = 1 + kPrecipitationWander * variability * wander(seed, kOfRain, time);
  for (double* part :
       {&s.precipitation.rain, &s.precipitation.snow, &s.precipitation.sleet, &s.precipitation.hail})
    *part *= wetter;
}

}  // namespace

void letWander(State& state, const WeatherSettings& s, std::uint64_t seed, double seconds) {
  if (s.variability > 0) turnAndScale(state, s.variability, seed, seconds / s.wanderSeconds);
}

State stateOf(const SiteSettings& s) {
  State out;
  out.wind = {s.windSpeed, core::wrappedDegrees(s.windDirection), s.gust, s.roughness, s.gradientHeight, {}};
  for (std::size_t i = 0; i < kWindLevels; ++i)
    out.wind.levels[i] = {s.levels[i].height, s.levels[i].speed, core::wrappedDegrees(s.levels[i].direction)};
  for (std::size_t i = 0; i < kLayers; ++i) {
    const WeatherLayerSettings& l = s.layers[i];
    out.layers[i] = {l.genus, l.base, l.top, l.cover, l.density};
  }
  out.fog = {s.fog, s.fogTop};
  out.precipitation = {s.rain, s.snow, s.sleet, s.hail};
  out.visibilityM = s.visibility;
  out.temperatureC = s.temperature;
  out.pressurePa = s.pressure * 100;
  out.lightningPerMinute = s.lightning;
  out.turbulenceSeverity = s.severity;
  return out;
}

double shareAlong(const glm::dvec2& first, const glm::dvec2& second, double approachSeconds, double seconds,
                  const glm::dvec2& xz) {
  const glm::dvec2 way = second - first, here = xz - first;
  const double length2 = way.x * way.x + way.y * way.y;
  const double along = length2 > 0 ? (here.x * way.x + here.y * way.y) / length2 : 0;
  const double approached = approachSeconds > 0 ? seconds / approachSeconds : 0;
  return smoothShare(along + approached);
}

double siteShare(const WeatherSettings& s, double seconds, const glm::dvec2& xz) {
  if (!s.secondSite) return 0;
  return shareAlong({s.sites[0].eastM, -s.sites[0].northM}, {s.sites[1].eastM, -s.sites[1].northM},
                    s.approachSeconds, seconds, xz);
}

State stateAt(const WeatherSettings& s, std::uint64_t seed, double seconds, const glm::dvec2& xz) {
  const double share = siteShare(s, seconds, xz);
  State out = share <= 0   ? stateOf(s.sites[0])
              : share >= 1 ? stateOf(s.sites[1])
                           : mixed(stateOf(s.sites[0]), stateOf(s.sites[1]), share);
  letWander(out, s, seed, seconds);
  return out;
}

bool hasClouds(const WeatherSettings& s) {
  const auto clouded = [](const SiteSettings& site) {
    return std::ranges::any_of(site.layers, [](const auto& layer) { return layer.cover > 0; });
  };
  return clouded(s.sites[0]) || (s.secondSite && clouded(s.sites[1]));
}

void requireUsable(const WeatherSettings& s) {
  for (std::size_t i = 0; i < kSites; ++i) {
    try {
      requireUsable(stateOf(s.sites[i]));
    } catch (const core::RangeError& error) {
      throw core::RangeError("weather.sites." + std::to_string(i) + "." + error.what());
    }
  }
}

}  // namespace skydrop::weather
