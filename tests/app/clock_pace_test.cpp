// The clock of the sky goes on from where it is when its speed changes in flight.
#include "app/session/clock_pace.h"

#include <gtest/gtest.h>

#include "skydrop/render/frame/sky_clock.h"

namespace skydrop::app {
namespace {

constexpr double kSecondsPerDay = 86400;

double clockSeconds(const render::SunSettings& sun, double simulated) {
  return (render::clockDays(sun, simulated) - render::clockDays(render::SunSettings{}, 0)) * kSecondsPerDay;
}

TEST(ClockPace, anotherSpeedDoesNotMoveTheClock) {
  // Fast, held, slow and back, at several times: at each change the clock shows what it showed, within a
  // millisecond, and then goes on at its new speed.
  render::SunSettings sun;
  ClockPace pace;
  EXPECT_FALSE(pace.follow(sun, 0));
  double now = 0;
  for (const double speed : {60.0, 0.0, 3600.0, 1.0}) {
    now += 100;
    const double before = clockSeconds(sun, now);
    sun.timeScale = speed;
    EXPECT_TRUE(pace.follow(sun, now));
    EXPECT_NEAR(clockSeconds(sun, now), before, 1e-3) << speed;
    EXPECT_NEAR(clockSeconds(sun, now + 10), before + 10 * speed, 1e-3) << speed;
    EXPECT_FALSE(pace.follow(sun, now + 5)) << "nothing has changed since";
  }
  // 100 s at 1, 100 s at 60, 100 s held, 100 s at 3600: the sum, and no more.
  EXPECT_NEAR(clockSeconds(sun, now), 100 + 6000 + 0 + 360000, 0.01);
}

TEST(ClockPace, layersThatAreComposedAnewKeepIt) {
  // A quality that is picked puts all rows back to their files, the offset too: it returns.
  render::SunSettings sun;
  ClockPace pace;
  pace.follow(sun, 0);
  sun.timeScale = 600;
  pace.follow(sun, 50);
  const double before = clockSeconds(sun, 60);
  sun.offsetSeconds = 0;
  EXPECT_TRUE(pace.follow(sun, 60));
  EXPECT_NEAR(clockSeconds(sun, 60), before, 1e-3);
}

TEST(ClockPace, whatIsAskedForHoldsAndANewFlightBeginsAnew) {
  render::SunSettings sun;
  sun.offsetSeconds = 30;
  ClockPace pace;
  pace.follow(sun, 0);
  sun.timeScale = 600;
  pace.follow(sun, 50);
  sun.offsetSeconds = 7;
  pace.take(sun);
  EXPECT_FALSE(pace.follow(sun, 60));
  EXPECT_EQ(sun.offsetSeconds, 7);
  pace.restart();
  EXPECT_TRUE(pace.follow(sun, 0));
  EXPECT_EQ(sun.offsetSeconds, 30) << "as the flight before began";
}

}  // namespace
}  // namespace skydrop::app
