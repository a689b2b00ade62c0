#include "skydrop/weather/wind_profile.h"

#include <algorithm>
#include <cmath>

#include "skydrop/core/deterministic_math.h"

namespace skydrop::weather {
namespace {

namespace dmath = core::dmath;

constexpr double kAnemometerM = 10;  // where surface winds are measured
constexpr double kTwentyFeetM = 6.096;
// The strongest gust of some minutes exceeds the mean by about three standard deviations.
constexpr double kGustSigmas = 3;
// Of sigma_u over W20 at 20 feet (MIL-F-8785C, figure 11): .1 / (.177 + .000823 * 20)^.4.
constexpr double kLongitudinalShare = 0.192914;

}  // namespace

glm::dvec2 windVelocity(double speedMps, double directionDeg) {
  const double from = directionDeg * dmath::kRadPerDeg;  // 0 = -z, 90 = +x
  return {-speedMps * dmath::sin(from), speedMps * dmath::cos(from)};
}

WindProfile::WindProfile(const Wind& wind)
    : roughnessM_(wind.roughnessM), gradientHeightM_(wind.gradientHeightM) {
  inverseLog_ = 1 / dmath::log(1 + gradientHeightM_ / roughnessM_);
  const double free = wind.speedMps / nearGround(kAnemometerM);
  knots_[0] = {gradientHeightM_, windVelocity(free, wind.directionDeg)};
  for (std::size_t i = 0; i < kWindLevels; ++i) {
    const WindLevel& level = wind.levels[i];
    knots_[i + 1] = {level.heightM, windVelocity(level.speedMps, level.directionDeg)};
  }
  const double mean = free * nearGround(kTwentyFeetM);
  const double gusts = wind.gustMps / kGustSigmas / kLongitudinalShare;
  w20_ = std::sqrt(mean * mean + gusts * gusts);
}

double WindProfile::nearGround(double aboveGroundM) const {
  if (!(aboveGroundM > 0)) return 0;
  if (aboveGroundM >= gradientHeightM_) return 1;
  return dmath::log(1 + aboveGroundM / roughnessM_) * inverseLog_;
}

glm::dvec3 WindProfile::at(double heightM, double aboveGroundM) const {
  if (!std::isfinite(heightM)) return glm::dvec3(0);
  glm::dvec2 free = knots_.front().velocity;
  if (heightM >= knots_.back().heightM) {
    free = knots_.back().velocity;
  } else if (heightM > knots_.front().heightM) {
    std::size_t above = 1;
    while (heightM >= knots_[above].heightM) ++above;
    const Knot& low = knots_[above - 1];
    const Knot& high = knots_[above];
    free = low.velocity +
           (high.velocity - low.velocity) * ((heightM - low.heightM) / (high.heightM - low.heightM));
  }
  const glm::dvec2 here = free * nearGround(aboveGroundM);
  return {here.x, 0, here.y};
}

}  // namespace skydrop::weather
