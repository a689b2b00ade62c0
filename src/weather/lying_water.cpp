#include "skydrop/weather/lying_water.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "skydrop/weather/fall.h"

namespace skydrop::weather {
namespace {

constexpr double kSnowUpToC = 0.5, kLapsePerM = 0.0065;
constexpr double kSecondsAnHour = 3600, kHoursADay = 24;
constexpr double kBasePerDegreeM = 125;  // of the spread between temperature and dew point
constexpr double kUsualSpreadC = 8;      // without a cloud to tell
constexpr double kMostSpreadC = 20;
constexpr double kMeltMmPerDegreeDay = 4;   // of snow (Hock 2003)
constexpr double kSublimationMmPerDay = 1;  // the order of it
constexpr double kMoistRate = 0.3;          // mm/h, that leaves e^-1 of the drying: rain moistens the air
constexpr double kShortestStepS = 30;       // the newest; older ones are longer

// hPa, over water (Magnus; Alduchov and Eskridge 1996).
double saturation(double celsius) { return 6.1094 * std::exp(17.625 * celsius / (celsius + 243.04)); }

double lacking(const State& s) {
  const Layer* layer = feedingLayer(s);
  const double spread = layer ? std::clamp(layer->baseM / kBasePerDegreeM, 0.5, kMostSpreadC) : kUsualSpreadC;
  return saturation(s.temperatureC) - saturation(s.temperatureC - spread);
}

// One stretch of an even rate: towards where filling and drying balance.
double after(double share, double fillsPerS, double driesPerS, double seconds) {
  const double all = fillsPerS + driesPerS, level = fillsPerS / all;
  return level + (share - level) * std::exp(-all * seconds);
}

struct Rates {
  double wetPerS, dryPerS, snowPerS, meltPerS;
};

Rates ratesOf(const State& s) {
  const Precipitation ground = fallAt(s, 0), high = fallAt(s, std::max(snowLineM(s), 0.0) + 300);
  const double water = ground.rain + ground.sleet + ground.hail;
  return {water / (kFilmMm * kSecondsAnHour), std::exp(-water / kMoistRate) / dryingSeconds(s),
          high.snow / (kSnowCoverMm * kSecondsAnHour), std::exp(-high.snow / kMoistRate) / meltingSeconds(s)};
}

// Knots from a time back to one that is so much earlier, the latest first: multiples of a step that doubles
// on the way back, so that they stay where they are as time goes on until two steps become one.
std::vector<double> knotsBack(double seconds, double backS, int stepsALevel) {
  std::vector<double> knots{seconds};
  double step = kShortestStepS, knot = std::floor(seconds / step) * step;
  while (seconds - knots.back() < backS) {
    for (int i = 0; i < stepsALevel || std::fmod(knot, 2 * step) != 0; ++i, knot -= step)
      knots.push_back(knot);
    step *= 2;
  }
  return knots;
}

}  // namespace

double snowLineM(const State& state) { return (state.temperatureC - kSnowUpToC) / kLapsePerM; }

double dryingSeconds(const State& s) {
  const double mmPerDay = 0.26 * (1 + 0.54 * s.wind.speedMps) * std::max(lacking(s), 0.0);
  const double hours = kFilmMm / std::max(mmPerDay / kHoursADay, 1e-6);
  return std::clamp(hours * kSecondsAnHour, 300.0, 21600.0);
}

double meltingSeconds(const State& s) {
  const double warm = std::max(std::min(s.temperatureC, kSnowUpToC), 0.0);
  const double mmPerDay = kSublimationMmPerDay + kMeltMmPerDegreeDay * warm;
  return std::clamp(kSnowCoverMm / (mmPerDay / kHoursADay) * kSecondsAnHour, 1800.0, 86400.0);
}

LyingWater lyingWater(const Moment& moment, const glm::dvec2& xz, int stepsALevel) {
  Moment then = moment;
  const auto ratesAt = [&](double seconds) {
    then.seconds = seconds;
    return ratesOf(then.at(xz));
  };
  const State now = moment.at(xz);
  const double memoryS = std::max(dryingSeconds(now), meltingSeconds(now));
  const std::vector<double> knots = knotsBack(moment.seconds, kLyingTimes * memoryS, stepsALevel);
  LyingWater lying;
  for (std::size_t i = knots.size() - 1; i > 0; --i) {
    const double from = knots[i], to = knots[i - 1];
    const Rates r = ratesAt(0.5 * (from + to));
    if (i == knots.size() - 1) {
      lying = {r.wetPerS / (r.wetPerS + r.dryPerS), r.snowPerS / (r.snowPerS + r.meltPerS)};
      continue;
    }
    lying.wet = after(lying.wet, r.wetPerS, r.dryPerS, to - from);
    lying.snow = after(lying.snow, r.snowPerS, r.meltPerS, to - from);
  }
  return lying;
}

bool everFalls(const Moment& moment) {
  const auto ofForecast = [](const Forecast& forecast) {
    for (const Timeline* site : {&forecast.near, &forecast.far})
      for (const TimedState& timed : site->states())
        if (rateOf(timed.state.precipitation) > 0) return true;
    return false;
  };
  const auto ofSites = [&] {
    const WeatherSettings& s = *moment.settings;
    return rateOf(stateOf(s.sites[0]).precipitation) > 0 ||
           (s.secondSite && rateOf(stateOf(s.sites[1]).precipitation) > 0);
  };
  if (moment.forecast ? ofForecast(*moment.forecast) : ofSites()) return true;
  if (!moment.handover) return false;
  return moment.handover->from ? ofForecast(*moment.handover->from) : ofSites();
}

}  // namespace skydrop::weather
