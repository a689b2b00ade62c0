// Sun, moon and time where their formulas are hard.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <string>
#include <string_view>

#include "skydrop/core/hash.h"
#include "skydrop/render/frame/sky_light.h"
#include "skydrop/sky/almanac.h"
#include "skydrop/sky/refraction.h"
#include "skydrop/sky/rise_and_set.h"
#include "support/instrumented.h"
#include "support/mutants.h"

namespace skydrop::sky {
namespace {

double daysOf(std::string_view utc) { return daysSinceJ2000(parseInstant(utc)); }

bool isSound(const Body& body) {
  return body.horizontal.azimuthDegrees >= 0 && body.horizontal.azimuthDegrees < 360 &&
         std::abs(body.horizontal.elevationDegrees) <= 90 && body.distanceKm > 0 &&
         std::abs(glm::length(worldDirection(body.horizontal)) - 1) < 1e-12;
}

bool isSound(const MoonPhase& moon) {
  return moon.phase >= 0 && moon.phase < 1 && moon.illuminatedFraction >= 0 &&
         moon.illuminatedFraction <= 1 && moon.brightLimbDegrees >= 0 && moon.brightLimbDegrees < 360 &&
         moon.brightLimbTiltDegrees >= 0 && moon.brightLimbTiltDegrees < 360;
}

TEST(Stability, S01_sunAndMoonAtThePolesTurnRoundEvenly) {
  // At a pole and within a hair of it: the elevation is the declination (the sun's but for its parallax of
  // 0.0025 degrees, the moon's for 1), the azimuth turns by 360 degrees a day without a jump, and both sides
  // agree.
  for (const double pole : {90.0, -90.0}) {
    double before = sunAt(daysOf("2026-05-01"), {pole, 30}).horizontal.azimuthDegrees;
    for (int minute = 1; minute <= 2880; ++minute) {
      const double days = daysOf("2026-05-01") + minute / 1440.0;
      const Body sun = sunAt(days, {pole, 30}), moon = moonAt(days, {pole, 30});
      ASSERT_TRUE(isSound(sun) && isSound(moon) && isSound(moonPhase(days, {pole, 30})));
      ASSERT_NEAR(sun.horizontal.elevationDegrees, std::copysign(1, pole) * sun.declinationDegrees, 1e-9);
      ASSERT_NEAR(moon.horizontal.elevationDegrees, std::copysign(1, pole) * moon.declinationDegrees, 1e-9);
      const double turn = std::remainder(sun.horizontal.azimuthDegrees - before, 360);
      ASSERT_NEAR(turn, std::copysign(0.25, pole), 0.001) << minute;
      before = sun.horizontal.azimuthDegrees;
      const Body near = sunAt(days, {pole - std::copysign(1e-9, pole), 30});
      ASSERT_LT(glm::length(worldDirection(near.horizontal) - worldDirection(sun.horizontal)), 1e-9);
    }
    const Events events = sunEvents(daysOf("2026-05-01"), {pole, 30});
    EXPECT_FALSE(events.rise || events.set);
    EXPECT_EQ(events.horizon, pole > 0 ? Horizon::staysAbove : Horizon::staysBelow);
    EXPECT_TRUE(events.transit);
  }
}

// The place that the body stands in the zenith of.
Place under(Body (*bodyAt)(double, const Place&), double days) {
  Place place;
  for (int i = 0; i < 40; ++i) {
    const Body body = bodyAt(days, place);
    place.latitudeDegrees += body.declinationDegrees - place.latitudeDegrees;
    place.longitudeDegrees -= body.hourAngleDegrees;
  }
  return place;
}

TEST(Stability, S02_sunAndMoonExactlyAtZenithAndNadir) {
  // Sound, unit and near the vertical on the spot and all around it; exactly vertical directions have azimuth
  // 0, and the bright limb a tilt.
  for (const char* utc : {"2026-03-20T12:00", "1950-06-01T03:30", "2050-12-31T23:59"}) {
    const double days = daysOf(utc);
    for (const auto bodyAt : {sunAt, moonAt}) {
      const Place spot = under(bodyAt, days);
      const Place opposite{-spot.latitudeDegrees, spot.longitudeDegrees + 180};
      EXPECT_GT(bodyAt(days, spot).horizontal.elevationDegrees, 90 - 1e-6) << utc;
      EXPECT_LT(bodyAt(days, opposite).horizontal.elevationDegrees, -90 + 0.01) << "the earth is no sphere";
      for (const double step : {0.0, 1e-14, 1e-12, 1e-9, 1e-6}) {
        for (const Place& place : {Place{spot.latitudeDegrees + step, spot.longitudeDegrees},
                                   Place{opposite.latitudeDegrees, opposite.longitudeDegrees - step}}) {
          EXPECT_TRUE(isSound(bodyAt(days, place))) << utc << ' ' << step;
          EXPECT_TRUE(isSound(moonPhase(days, place))) << utc << ' ' << step;
        }
      }
    }
  }
  for (const double side : {1.0, -1.0}) {
    const Horizontal vertical = horizontalOf({0, side, 0});
    EXPECT_EQ(vertical.azimuthDegrees, 0);
    EXPECT_EQ(vertical.elevationDegrees, 90 * side);
    EXPECT_EQ(horizontalOf({-1e-17, side, 1e-17}).azimuthDegrees, 0) << "a rounding is no direction";
    EXPECT_EQ(refracted({0, 90 * side}).elevationDegrees, 90 * side);
  }
}

TEST(Stability, S03_aYearAtThreeThousandSixHundredTimesStaysContinuous) {
  // 8760 s of flight at 60 frames a second, each a minute of the clock: the sun goes on by 0.25 degrees of
  // its circle, and by at most half as much again where refraction lifts it (its rate is 0.16 degrees a
  // degree at -1). An hour before and after the flight, and at any scale, the place depends on the clock
  // alone.
  render::SunSettings sun;
  sun.source = render::SunSource::clock;
  sun.timeScale = 3600;
  sun.utcMs = parseInstant("2027-12-31T00:00").utcMs;
  glm::dvec3 before = render::directionToSun(sun, 0);
  double longest = 0;
  const int frames = test::repetitions(8760 * 60);
  for (int frame = 1; frame <= frames; ++frame) {
    const glm::dvec3 now = render::directionToSun(sun, frame / 60.0);
    const double step = glm::length(now - before);
    ASSERT_NEAR(glm::length(now), 1, 1e-12);
    longest = std::max(longest, step);
    before = now;
  }
  EXPECT_LT(glm::degrees(longest), 0.25 * 1.5);
  EXPECT_GT(glm::degrees(longest), 0.2);
  render::SunSettings slow = sun;
  slow.timeScale = 1;
  slow.utcMs += 3600 * std::int64_t{1000} * 3600;
  EXPECT_LT(glm::length(render::directionToSun(sun, 3600) - render::directionToSun(slow, 0)), 1e-9);
}

TEST(Stability, S04_theFirstAndTheLastYearJoinTheOthers) {
  // From a second before to a second after the ends of 1950 and 2050, of each century, and of all years that
  // can be written: the sun moves on by the two seconds' 0.0083 degrees, the moon no more.
  for (const char* utc : {"1950-01-01", "2051-01-01", "2050-01-01", "2000-01-01", "2025-01-01",
                          "1000-01-01T00:00:01", "1700-01-01", "2100-01-01", "3000-12-31T23:59:58"}) {
    const double days = daysOf(utc), second = 1.0 / 86400;
    for (const Place& place : {Place{0, 0}, Place{52, 13}, Place{-77, 166}}) {
      for (const auto bodyAt : {sunAt, moonAt}) {
        const Body a = bodyAt(days - second, place), b = bodyAt(days + second, place);
        EXPECT_TRUE(isSound(a) && isSound(b)) << utc;
        const double moved = glm::length(worldDirection(a.horizontal) - worldDirection(b.horizontal));
        EXPECT_LT(glm::degrees(moved), 0.0085) << utc;
      }
    }
  }
}

TEST(Stability, S05_noTextIsTakenForADateThatDoesNotExist) {
  // Whatever is damaged in a good text, it is refused with a reason and leaves the instant as it was, or it
  // is an instant of the calendar, which its own text gives again.
  int refused = 0;
  for (const char* good : {"2024-02-29T12:00:00Z", "2026-06-21T14:30:59.125+05:30", "1999-12-31"}) {
    test::forEachMutant(good, 5000, [&](const std::string& mutant) {
      Instant instant{42};
      const std::string reason = readInstant(mutant, instant);
      refused += !reason.empty();
      if (!reason.empty()) {
        ASSERT_EQ(instant.utcMs, 42) << mutant;
        return;
      }
      ASSERT_TRUE(instant >= kFirstInstant && instant <= kLastInstant) << mutant;
      ASSERT_EQ(parseInstant(instantText(instant)), instant) << mutant;
    });
  }
  EXPECT_GT(refused, 1000);
  for (int year = kFirstYear; year <= kLastYear; ++year) {
    Instant instant;
    const bool leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
    EXPECT_EQ(readInstant(std::to_string(year) + "-02-29", instant).empty(), leap) << year;
  }
}

TEST(Stability, S06_sunAndMoonAtTheSamePlace) {
  // The total eclipse of 2024-04-08 at its greatest (25.29 N, 104.15 W, 18:17:20 UT): their middles are
  // within 0.02 degrees, the moon is new and dark, and its bright limb has an answer, also where their
  // directions are one.
  const double days = daysOf("2024-04-08T18:17:20Z");
  const Place place{25.29, -104.15};
  const Body sun = sunAt(days, place), moon = moonAt(days, place);
  const double apart = glm::length(worldDirection(sun.horizontal) - worldDirection(moon.horizontal));
  EXPECT_LT(glm::degrees(apart), 0.02);
  EXPECT_GT(moon.radiusDegrees, sun.radiusDegrees) << "total";
  core::RandomStream random{3, 0};
  for (int i = 0; i < 2000; ++i) {
    const double time = days + (random.nextUnit() - 0.5) * 1e-3;
    const Place near{place.latitudeDegrees + random.nextUnit() - 0.5,
                     place.longitudeDegrees + random.nextUnit() - 0.5};
    const MoonPhase phase = moonPhase(time, near);
    ASSERT_TRUE(isSound(phase));
    ASSERT_LT(phase.illuminatedFraction, 1e-3);
    ASSERT_LT(std::abs(std::remainder(phase.phase, 1)), 0.002);
  }
}

}  // namespace
}  // namespace skydrop::sky
