#include "skydrop/weather/draughts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "skydrop/core/deterministic_math.h"

namespace skydrop::weather {
namespace {

namespace dmath = core::dmath;

constexpr double kHeavyRain = 20;       // mm/h
constexpr double kMostSinkShare = 0.5;  // of the updraught, between columns
constexpr double kRidgeM = 2500;        // wavelength
constexpr double kSteepest = 0.5;
constexpr double kMostSlopeWind = 12;  // m/s

double smoothlyLimited(double x, double most) {
  const double r = x / most;
  return x / std::sqrt(1 + r * r);
}

}  // namespace

GenusAir airOf(Genus genus) {
  // Order of Genus.
  static constexpr std::array<GenusAir, 10> kAirs{{{0, 0, 0.3},     // stratus
                                                   {0.4, 0, 0.7},   // stratocumulus
                                                   {2.5, 0, 1.5},   // cumulus
                                                   {0, 0, 0.3},     // altostratus
                                                   {0.4, 0, 0.6},   // altocumulus
                                                   {0, 0, 0.3},     // cirrus
                                                   {0, 0, 0.2},     // cirrostratus
                                                   {0.2, 0, 0.5},   // cirrocumulus
                                                   {0, 1, 0.8},     // nimbostratus
                                                   {12, 9, 5.0}}};  // cumulonimbus
  return kAirs[static_cast<std::size_t>(genus)];
}

double cloudDraught(const Layer& layer, double column, double heightM, double groundM, double rain) {
  if (!(layer.cover > 0)) return 0;
  const GenusAir air = airOf(layer.genus);
  if (air.updraughtMps == 0 && air.downdraughtMps == 0) return 0;
  double shape = 0, dragged = 0;
  if (heightM <= layer.baseM) {
    const double share = std::clamp((heightM - groundM) / std::max(layer.baseM - groundM, 1.0), 0.0, 1.0);
    shape = share > 0 ? dmath::pow(share, 1.0 / 3) : 0;
    dragged = std::clamp(rain / kHeavyRain, 0.0, 1.0);
  } else {
    const double share = std::min((heightM - layer.baseM) / (layer.topM - layer.baseM), 1.0);
    shape = 1 - share * share;
    // Rain drags the lowest quarter of the cloud along.
    dragged = std::clamp(rain / kHeavyRain, 0.0, 1.0) * std::clamp(1 - 4 * share, 0.0, 1.0);
  }
  const double density = std::min(layer.density, 1.0) * std::clamp(column, 0.0, 1.0);
  const double rises = air.updraughtMps * (1 - dragged) - air.downdraughtMps * dragged;
  const double sinks = std::min(layer.cover / (1 - std::min(layer.cover, 0.9)), kMostSinkShare) *
                       air.updraughtMps * (1 - dragged);
  return shape * (density * rises - (1 - density) * sinks);
}

double slopeDraught(const glm::dvec2& windMps, const glm::dvec2& gradient, double aboveGroundM) {
  const double steepness = std::sqrt(gradient.x * gradient.x + gradient.y * gradient.y);
  if (!(steepness > 0)) return 0;
  const double share = smoothlyLimited(steepness, kSteepest) / steepness;
  const double rise = (windMps.x * gradient.x + windMps.y * gradient.y) * share;
  const double fades = dmath::exp(-dmath::kTwoPi / kRidgeM * std::max(aboveGroundM, 0.0));
  return smoothlyLimited(rise * fades, kMostSlopeWind);
}

}  // namespace skydrop::weather
