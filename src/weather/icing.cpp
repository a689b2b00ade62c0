#include "skydrop/weather/icing.h"

#include <algorithm>

#include "skydrop/core/deterministic_math.h"

namespace skydrop::weather {
namespace {

namespace dmath = core::dmath;

constexpr double kWorstC = -7, kColdestC = -25;
constexpr double kGrowthPerS = 1 / 45.0;        // 1/s: 86 % after 90 s
constexpr double kFreezingRainPerS = 1 / 60.0;  // in 5 mm/h
constexpr double kMeltingPerSPerK = 1 / 300.0;
constexpr double kSublimationPerS = 1 / 900.0;

}  // namespace

double iceAfter(double ice, const IcingAir& air, double rate, double seconds) {
  const double t = air.temperatureC;
  double grows = 0, goes = 0;
  if (t < 0) {
    const double share = t >= kWorstC ? t / kWorstC : std::max((t - kColdestC) / (kWorstC - kColdestC), 0.0);
    grows = rate * (kGrowthPerS * share * std::clamp(air.cloudDensity, 0.0, 1.0) +
                    kFreezingRainPerS * std::min(air.rain / 5, 1.0) * std::min(-t, 1.0) * (t > kColdestC));
    if (grows <= 0) goes = kSublimationPerS;
  } else {
    goes = kMeltingPerSPerK * t;
  }
  const double sum = grows + goes;
  if (!(sum > 0)) return ice;
  const double end = grows / sum;
  return std::clamp(end + (ice - end) * dmath::exp(-sum * seconds), 0.0, 1.0);
}

}  // namespace skydrop::weather
