#include "skydrop/weather/state.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "skydrop/core/angles.h"
#include "skydrop/core/error.h"

namespace skydrop::weather {
namespace {

[[noreturn]] void refuse(const std::string& place, const std::string& reason) {
  throw core::RangeError(place + ": " + reason);
}

std::string text(double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%g", value);
  return digits;
}

void require(const std::string& place, double value, double min, double max) {
  if (value >= min && value <= max) return;  // NaN is neither
  refuse(place, text(value) + " is out of range " + text(min) + " to " + text(max));
}

double between(double a, double b, double t) { return a + (b - a) * t; }

WindLevel mixed(const WindLevel& a, const WindLevel& b, double t) {
  return {between(a.heightM, b.heightM, t), between(a.speedMps, b.speedMps, t),
          mixedDirection(a.directionDeg, a.speedMps, b.directionDeg, b.speedMps, t)};
}

Wind mixed(const Wind& a, const Wind& b, double t) {
  Wind out;
  out.speedMps = between(a.speedMps, b.speedMps, t);
  out.directionDeg = mixedDirection(a.directionDeg, a.speedMps, b.directionDeg, b.speedMps, t);
  out.gustMps = between(a.gustMps, b.gustMps, t);
  out.roughnessM = between(a.roughnessM, b.roughnessM, t);
  out.gradientHeightM = between(a.gradientHeightM, b.gradientHeightM, t);
  for (std::size_t i = 0; i < kWindLevels; ++i) out.levels[i] = mixed(a.levels[i], b.levels[i], t);
  return out;
}

Layer mixed(const Layer& a, const Layer& b, double t) {
  Layer out;
  if (a.genus != b.genus && a.cover > 0 && b.cover > 0) {
    out = t < 0.5 ? a : b;
    out.cover *= std::abs(1 - 2 * t);
    return out;
  }
  // What has no cover has no place either.
  const Layer& from = a.cover > 0 ? a : b;
  const Layer& to = b.cover > 0 ? b : a;
  out.genus = a.cover > 0 ? a.genus : b.genus;
  out.baseM = between(from.baseM, to.baseM, t);
  out.topM = between(from.topM, to.topM, t);
  out.density = between(from.density, to.density, t);
  out.cover = between(a.cover, b.cover, t);
  return out;
}

}  // namespace

double mixedDirection(double fromDeg, double fromSpeed, double toDeg, double toSpeed, double share) {
  const double from = (1 - share) * fromSpeed, to = share * toSpeed;
  const double t = from + to > 0 ? to / (from + to) : share;
  double turn = core::wrappedDegrees(toDeg - fromDeg);
  if (turn > 180) turn -= 360;
  return core::wrappedDegrees(fromDeg + turn * t);
}

State mixed(const State& a, const State& b, double share) {
  const double t = share > 0 ? std::min(share, 1.0) : 0;
  if (t <= 0) return a;
  if (t >= 1) return b;
  State out;
  out.wind = mixed(a.wind, b.wind, t);
  for (std::size_t i = 0; i < kLayers; ++i) out.layers[i] = mixed(a.layers[i], b.layers[i], t);
  out.fog = {between(a.fog.extinction, b.fog.extinction, t), between(a.fog.topM, b.fog.topM, t)};
  out.precipitation = {between(a.precipitation.rain, b.precipitation.rain, t),
                       between(a.precipitation.snow, b.precipitation.snow, t),
                       between(a.precipitation.sleet, b.precipitation.sleet, t),
                       between(a.precipitation.hail, b.precipitation.hail, t)};
  out.visibilityM = between(a.visibilityM, b.visibilityM, t);
  out.temperatureC = between(a.temperatureC, b.temperatureC, t);
  out.pressurePa = between(a.pressurePa, b.pressurePa, t);
  out.lightningPerMinute = between(a.lightningPerMinute, b.lightningPerMinute, t);
  out.turbulenceSeverity = between(a.turbulenceSeverity, b.turbulenceSeverity, t);
  return out;
}

void requireUsable(const State& s) {
  require("wind.speed", s.wind.speedMps, 0, 100);
  require("wind.direction", s.wind.directionDeg, 0, 360);
  require("wind.gust", s.wind.gustMps, 0, 60);
  require("wind.roughness", s.wind.roughnessM, 1e-5, 5);
  require("wind.gradientHeight", s.wind.gradientHeightM, 50, 2000);
  double below = s.wind.gradientHeightM;
  for (std::size_t i = 0; i < kWindLevels; ++i) {
    const WindLevel& level = s.wind.levels[i];
    const std::string place = "wind.levels." + std::to_string(i);
    require(place + ".speed", level.speedMps, 0, 150);
    require(place + ".direction", level.directionDeg, 0, 360);
    require(place + ".height", level.heightM, 0, 30000);
    if (!(level.heightM > below))
      refuse(place, "its height of " + text(level.heightM) + " m is not above the " + text(below) +
                        " m of the one below");
    below = level.heightM;
  }
  for (std::size_t i = 0; i < kLayers; ++i) {
    const Layer& layer = s.layers[i];
    const std::string place = "layers." + std::to_string(i);
    const int genus = static_cast<int>(layer.genus);
    if (genus < 0 || genus >= static_cast<int>(kGenusNames.size()))
      refuse(place + ".genus", std::to_string(genus) + " is none");
    require(place + ".cover", layer.cover, 0, 1);
    require(place + ".density", layer.density, 0, 4);
    require(place + ".base", layer.baseM, -500, 20000);
    require(place + ".top", layer.topM, -500, 20000);
    if (!(layer.topM > layer.baseM))
      refuse(place,
             "the top at " + text(layer.topM) + " m is not above the base at " + text(layer.baseM) + " m");
  }
  require("fog.extinction", s.fog.extinction, 0, 0.2);
  require("fog.top", s.fog.topM, -500, 5000);
  require("precipitation.rain", s.precipitation.rain, 0, 200);
  require("precipitation.snow", s.precipitation.snow, 0, 50);
  require("precipitation.sleet", s.precipitation.sleet, 0, 100);
  require("precipitation.hail", s.precipitation.hail, 0, 200);
  require("visibility", s.visibilityM, 10, 300000);
  require("temperature", s.temperatureC, -60, 60);
  require("pressure", s.pressurePa, 85000, 110000);
  require("lightning", s.lightningPerMinute, 0, 60);
  require("turbulence", s.turbulenceSeverity, 0, 6);
}

}  // namespace skydrop::weather
