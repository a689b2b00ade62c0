// One weather takes over from another without a jump.
#include "skydrop/weather/handover.h"

#include <gtest/gtest.h>

#include <cmath>

namespace skydrop::weather {
namespace {

constexpr std::int64_t kFirst = 1782000000000, kHour = 3600000;  // ms

std::shared_ptr<const Forecast> forecastFrom(std::int64_t firstMs, Genus genus, double warmer,
                                             double direction) {
  std::vector<TimedState> hours(12);
  for (std::size_t i = 0; i < hours.size(); ++i) {
    const auto hour = static_cast<double>(i);
    State& state = hours[i].state;
    hours[i].utcMs = firstMs + static_cast<std::int64_t>(i) * kHour;
    state.temperatureC = warmer + hour;
    state.wind.speedMps = 5;
    state.wind.directionDeg = direction;
    state.wind.levels = {{{1500, 8 + hour, direction}, {5500, 9, direction}, {10000, 20, direction}}};
    state.layers[0] = {genus, 1000 + 10 * hour, 2500, 0.8, 1};
    state.layers[1] = {Genus::altocumulus, 3500, 4200, i % 2 ? 0.0 : 0.6, 1};
    state.precipitation.rain = 0.1 * hour;
  }
  return std::make_shared<const Forecast>(Forecast{Timeline(hours), Timeline(hours), std::nullopt, 1});
}

double farthest(const State& a, const State& b) {
  double most = std::abs(a.temperatureC - b.temperatureC) / 10;
  double turn = std::abs(a.wind.directionDeg - b.wind.directionDeg);
  most = std::max(most, std::min(turn, 360 - turn) / 100);
  most = std::max(most, std::abs(a.precipitation.rain - b.precipitation.rain));
  for (std::size_t i = 0; i < kLayers; ++i) {
    most = std::max(most, std::abs(a.layers[i].cover - b.layers[i].cover));
    // Where there is no cloud, its height is nothing that is seen.
    if (a.layers[i].genus == b.layers[i].genus && std::min(a.layers[i].cover, b.layers[i].cover) > 0.01)
      most = std::max(most, std::abs(a.layers[i].baseM - b.layers[i].baseM) / 1000);
  }
  return most;
}

TEST(Handover, theSkyChangesWithoutAJumpAndHasBecomeTheNewOneAtItsEnd) {
  // 60 s, in steps of the simulation: no step changes temperature by .1 %, direction by .1 % of the turn,
  // cover or rain by more than a three hundredth; 1.5 / 7200 is the steepest that 3x^2 - 2x^3 has a step, and
  // a layer that changes its genus goes and comes twice as fast. The clock, which counts on from the first
  // hour of the first forecast, is 3 h ahead of the second's own.
  WeatherSettings settings;
  settings.variability = 0;
  const auto before = forecastFrom(kFirst, Genus::cumulus, 0, 350);
  const auto after = std::make_shared<const Forecast>(
      continuing(*forecastFrom(kFirst + 3 * kHour, Genus::stratus, 10, 40), *before));
  const ForecastClock clock{false, 4.5, 1};
  const Handover handover{before, clock, 100, 60};
  const auto at = [&](double seconds) {
    return stateAt(settings, after.get(), clock, &handover, 1, seconds, {0, 0});
  };
  EXPECT_EQ(at(100), stateAt(settings, *before, clock, 1, 100, {0, 0}));
  EXPECT_EQ(at(160), stateAt(settings, *after, clock, 1, 160, {0, 0}));
  EXPECT_NEAR(at(160).temperatureC, 10 + 1.5 + 160 / 3600.0, 1e-9) << "the same instant of the newer one";
  double most = 0;
  for (int i = 0; i < 60 * 120; ++i)
    most = std::max(most, farthest(at(100 + i / 120.0), at(100 + (i + 1) / 120.0)));
  EXPECT_LT(most, 1.0 / 300);
  EXPECT_GT(farthest(at(100), at(160)), 0.5) << "the two differ";
  EXPECT_EQ(strandWind(*after), strandWind(*before)) << "the strands of ice clouds do not turn";
}

TEST(Handover, theWayBackBeginsWhereTheWayThereWas) {
  WeatherSettings settings;
  settings.variability = 0;
  settings.sites[0].temperature = 30;
  const auto forecast = forecastFrom(kFirst, Genus::cumulus, 0, 100);
  const ForecastClock clock{false, 2, 1};
  const Handover there{forecast, clock, 10, 40};  // to the sites
  const double now = 23;
  const Handover back = turnedBack(there, nullptr, {}, now);
  const State before = stateAt(settings, nullptr, {}, &there, 1, now, {0, 0});
  const State after = stateAt(settings, forecast.get(), clock, &back, 1, now, {0, 0});
  EXPECT_LT(farthest(before, after), 1e-9);
  EXPECT_NEAR(newShare(there, now) + newShare(back, now), 1, 1e-12);
  EXPECT_EQ(newShare(back, now + 13), 1) << "back after as long as it went";
}

}  // namespace
}  // namespace skydrop::weather
