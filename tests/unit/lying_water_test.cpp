// Land that wets while it rains and dries afterwards, without a history: against closed forms, dense steps
// and itself after a jump in time.
#include "skydrop/weather/lying_water.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

namespace skydrop::weather {
namespace {

// Rain that a front takes away within a quarter of an hour.
WeatherSettings front() {
  WeatherSettings s;
  s.variability = 0;
  s.secondSite = true;
  s.approachSeconds = 900;
  for (SiteSettings& site : s.sites) site.layers[0] = {Genus::nimbostratus, 900, 4000, 1, 1};
  s.sites[0].rain = 6;
  s.sites[1].rain = 0;
  s.sites[1].eastM = s.sites[0].eastM;
  return s;
}

Moment at(const WeatherSettings& s, double seconds) {
  return {std::make_shared<const WeatherSettings>(s), 1, seconds};
}

TEST(LyingWater, ofEvenRainIsWhereFillingAndDryingBalance) {
  // 0.05 mm/h: r / c / (r / c + e^(-r / 0.3) / tau), at any time; none dry, all wet in heavy rain.
  WeatherSettings s = front();
  s.secondSite = false;
  for (const double rain : {0.0, 0.05, 0.3, 6.0}) {
    s.sites[0].rain = rain;
    const double dry = 3600 / dryingSeconds(at(s, 0).at({0, 0})) * std::exp(-rain / 0.3);
    const double expected = rain / kFilmMm / (rain / kFilmMm + dry);
    for (const double seconds : {-5000.0, 0.0, 77.7, 1e6})
      EXPECT_NEAR(lyingWater(at(s, seconds), {0, 0}).wet, expected, 1e-9) << rain << ' ' << seconds;
  }
  s.sites[0].rain = 0;
  EXPECT_FALSE(everFalls(at(s, 0)));
  EXPECT_TRUE(everFalls(at(front(), 0)));
}

TEST(LyingWater, driesByAnETimesItsDryingTimeAfterTheRain) {
  // The front has passed at 900 s; from then on what is left falls by e each dryingSeconds, within .005.
  const WeatherSettings s = front();
  const double tau = dryingSeconds(at(s, 2000).at({0, 0}));
  ASSERT_GT(tau, 600);
  ASSERT_LT(tau, 7200);
  EXPECT_GT(lyingWater(at(s, 0), {0, 0}).wet, 0.99);
  const double before = lyingWater(at(s, 1000), {0, 0}).wet;
  EXPECT_GT(before, 0.8) << "no longer wet as soon as the rain ends";
  for (const double later : {0.5, 1.0, 2.0, 3.0}) {
    const double left = lyingWater(at(s, 1000 + later * tau), {0, 0}).wet;
    EXPECT_NEAR(left, before * std::exp(-later), 0.005) << later;
  }
  EXPECT_LT(lyingWater(at(s, 1000 + 9 * tau), {0, 0}).wet, 0.001);
}

TEST(LyingWater, isNearItsLimitOfManySteps) {
  // Error against cost: root mean square of wet over two hours of a front, against 512 steps of each length.
  const WeatherSettings s = front();
  double worstShipped = 0;
  for (const int steps : {2, 4, 8, kLyingSteps, 32, 64}) {
    double sum = 0;
    int count = 0;
    for (double seconds = 0; seconds < 7200; seconds += 450, ++count) {
      const double apart =
          lyingWater(at(s, seconds), {0, 0}, steps).wet - lyingWater(at(s, seconds), {0, 0}, 512).wet;
      sum += apart * apart;
    }
    const double rms = std::sqrt(sum / count);
    std::printf("%4d steps of each length: %.5f of the ground\n", steps, rms);
    if (steps == kLyingSteps) worstShipped = rms;
  }
  EXPECT_LT(worstShipped, 0.01);
}

TEST(LyingWater, growsAndGoesWithoutAJump) {
  // In a wandering weather from second to second by no more than its fastest filling, across all knots, and
  // frozen time keeps it bit for bit.
  WeatherSettings s = front();
  s.variability = 0.5;
  double before = lyingWater(at(s, 0), {0, 0}).wet, most = 0;
  for (double seconds = 1; seconds < 3000; seconds += 1) {
    const double now = lyingWater(at(s, seconds), {0, 0}).wet;
    most = std::max(most, std::abs(now - before));
    before = now;
  }
  std::printf("at most %.5f of the ground a second\n", most);
  EXPECT_LT(most, 0.004);
  EXPECT_EQ(lyingWater(at(s, 1234.5), {50, 60}).wet, lyingWater(at(s, 1234.5), {50, 60}).wet);
}

TEST(LyingWater, ofSnowStaysInFrostAndMeltsInWarmth) {
  // Six hours after a snowfall in frost most lies still; at the snow line of a warm day it is gone in a day.
  WeatherSettings s = front();
  for (SiteSettings& site : s.sites) site.temperature = -5;
  s.sites[0].rain = 0;
  s.sites[0].snow = 2;
  EXPECT_GT(lyingWater(at(s, 0), {0, 0}).snow, 0.99);
  EXPECT_GT(lyingWater(at(s, 6 * 3600), {0, 0}).snow, 0.7);
  EXPECT_EQ(meltingSeconds(at(s, 0).at({0, 0})), 86400);
  for (SiteSettings& site : s.sites) site.temperature = 5;
  EXPECT_LT(lyingWater(at(s, 86400), {0, 0}).snow, 0.1);
}

}  // namespace
}  // namespace skydrop::weather
