// Sun, moon and time where their formulas are hard.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <string>
#include <string_view>

#include "skydrop/core/hash.h"
#include "skydrop/render/frame/sky_light.h"
#include "skydrop/sky/almanac.h"
#include "skydrop/sky/atmosphere.h"
#include "skydrop/sky/refraction.h"
#include "skydrop/sky/rise_and_set.h"
#include "support/instrumented.h"
#include "support/margin.h"
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
      ASSERT_TRUE(test::holds(
          "S01",
          test::apart(sun.horizontal.elevationDegrees, std::copysign(1, pole) * sun.declinationDegrees),
          test::atMost(1e-9), "degrees"));
      ASSERT_TRUE(test::holds(
          "S01",
          test::apart(moon.horizontal.elevationDegrees, std::copysign(1, pole) * moon.declinationDegrees),
          test::atMost(1e-9), "degrees"));
      const double turn = std::remainder(sun.horizontal.azimuthDegrees - before, 360);
      ASSERT_TRUE(
          test::holds("S01", test::apart(turn, std::copysign(0.25, pole)), test::atMost(0.001), "degrees"))
          << minute;
      before = sun.horizontal.azimuthDegrees;
      const Body near = sunAt(days, {pole - std::copysign(1e-9, pole), 30});
      ASSERT_TRUE(test::holds("S01",
                              glm::length(worldDirection(near.horizontal) - worldDirection(sun.horizontal)),
                              test::below(1e-9), "of length 1"));
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
  test::noFaults("S02", "differences");
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
    ASSERT_TRUE(test::holds("S03", test::apart(glm::length(now), 1), test::atMost(1e-12), "of length 1"));
    longest = std::max(longest, step);
    before = now;
  }
  EXPECT_TRUE(test::holds("S03", glm::degrees(longest), test::below(0.25 * 1.5), "degrees"));
  EXPECT_GT(glm::degrees(longest), 0.2);
  render::SunSettings slow = sun;
  slow.timeScale = 1;
  slow.utcMs += 3600 * std::int64_t{1000} * 3600;
  EXPECT_TRUE(test::holds("S03",
                          glm::length(render::directionToSun(sun, 3600) - render::directionToSun(slow, 0)),
                          test::below(1e-9), "of length 1"));
}

TEST(Stability, S04_theFirstAndTheLastYearJoinTheOthers) {
  // From a second before to a second after the ends of 1950 and 2050, of each century, and of all years that
  // can be written: the sun moves on by the two seconds' 0.0083 degrees, the moon no more.
  EXPECT_TRUE(test::holdsLive("S04"));
  for (const char* utc : {"1950-01-01", "2051-01-01", "2050-01-01", "2000-01-01", "2025-01-01",
                          "1000-01-01T00:00:01", "1700-01-01", "2100-01-01", "3000-12-31T23:59:58"}) {
    const double days = daysOf(utc), second = 1.0 / 86400;
    for (const Place& place : {Place{0, 0}, Place{52, 13}, Place{-77, 166}}) {
      for (const auto bodyAt : {sunAt, moonAt}) {
        const Body a = bodyAt(days - second, place), b = bodyAt(days + second, place);
        EXPECT_TRUE(isSound(a) && isSound(b)) << utc;
      }
    }
  }
}

TEST(Stability, S05_noTextIsTakenForADateThatDoesNotExist) {
  // Whatever is damaged in a good text, it is refused with a reason and leaves the instant as it was, or it
  // is an instant of the calendar, which its own text gives again.
  test::noFaults("S05", "inputs accepted");
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
  EXPECT_TRUE(test::holds("S06", glm::degrees(apart), test::below(0.02), "degrees"));
  EXPECT_GT(moon.radiusDegrees, sun.radiusDegrees) << "total";
  core::RandomStream random{3, 0};
  for (int i = 0; i < 2000; ++i) {
    const double time = days + (random.nextUnit() - 0.5) * 1e-3;
    const Place near{place.latitudeDegrees + random.nextUnit() - 0.5,
                     place.longitudeDegrees + random.nextUnit() - 0.5};
    const MoonPhase phase = moonPhase(time, near);
    ASSERT_TRUE(isSound(phase));
    ASSERT_TRUE(test::holds("S06", phase.illuminatedFraction, test::below(1e-3), "of 1"));
    ASSERT_TRUE(
        test::holds("S06", std::abs(std::remainder(phase.phase, 1)), test::below(0.002), "of a month"));
  }
}

// Finite, not negative, and no brighter than the sun's own light scattered at once.
bool isSound(const glm::dvec3& radiance) {
  for (int c = 0; c < 3; ++c) {
    if (!(std::isfinite(radiance[c]) && radiance[c] >= 0 && radiance[c] < 1e6)) return false;
  }
  return true;
}

bool isSound(const SkyLight& light) {
  return isSound(light.sun) && isSound(light.sky) && isSound(light.ground) &&
         isSound(sunDiscRadiance(light) / 1e3);
}

const double kHardSines[] = {1, -1, 0, 1e-300, -1e-300, 1e-9, -1e-9, 0.5, -0.5, 1 - 1e-16, -1 + 1e-16};

// Towards a sine of elevation, at an azimuth.
glm::dvec3 towards(double sine, double azimuth) {
  const double across = std::sqrt(std::max(1 - sine * sine, 0.0));
  return {across * std::cos(azimuth), sine, across * std::sin(azimuth)};
}

Atmosphere airOf(double visibilityM) { return makeAtmosphere(visibilityM, 1200, 0.7); }

TEST(Stability, S07_theSkyFromBelowTheSeaToOutsideTheAir) {
  // Sound in all directions; below the sea as from its surface; no jump at the end of the air; outside there
  // is no light above the air's limb, and light below it.
  for (const double height :
       {-1e9, -50.0, 0.0, 0.5, 1.0, 59999.0, 60001.0, 80000.0, 99999.0, 100001.0, 4e5, 1e9}) {
    for (const double sun : {60.0, 3.0, -4.0}) {
      const SkyLight light = skyLight(airOf(1e5), directionToSun(sun, 90), height);
      ASSERT_TRUE(isSound(light)) << height;
      for (const double sine : kHardSines) {
        for (const double azimuth : {0.0, 2.0}) {
          const glm::dvec3 direction = towards(sine, azimuth);
          ASSERT_TRUE(isSound(skyRadiance(light, direction))) << height << ' ' << sine;
          for (const double distance : {0.0, 1.0, 1e5, 1e30})
            ASSERT_TRUE(isSound(airRadiance(light, direction, distance))) << height << ' ' << sine;
        }
      }
    }
  }
  const auto at = [](double height) { return skyLight(airOf(1e5), directionToSun(30, 90), height); };
  const glm::dvec3 up = towards(0.4, 1);
  EXPECT_EQ(skyRadiance(at(-50), up), skyRadiance(at(0), up));
  for (const double border : {60000.0, 100000.0}) {
    for (const double sine : {-0.1, -0.17, -0.3, -0.9}) {
      const glm::dvec3 inside = skyRadiance(at(border - 1), towards(sine, 1)),
                       outside = skyRadiance(at(border + 1), towards(sine, 1));
      for (int c = 0; c < 3; ++c)
        EXPECT_TRUE(
            test::holds("S07", test::apart(inside[c] / outside[c], 1), test::atMost(0.02), "relative"))
            << border << ' ' << sine;
    }
  }
  const SkyLight outside = at(4e5);
  const double limb = core::shared::f64::airEndsSine(4e5), sea = core::shared::f64::horizonSine(4e5);
  EXPECT_TRUE(test::holds("S07", glm::length(skyRadiance(outside, towards(limb + 1e-3, 1)) - outside.night),
                          test::below(1e-5), "light"));
  EXPECT_GT(skyRadiance(outside, towards(sea + 0.1 * (limb - sea), 1)).z, 0.1) << "the limb";
}

TEST(Stability, S08_viewAndSunExactlyAtZenithNadirAndHorizon) {
  // Sound; the zenith and the nadir have one radiance whatever the azimuth that rounding gives them; a sun in
  // the zenith lights all azimuths alike.
  for (const double sunSine : kHardSines) {
    for (const double sunAzimuth : {0.0, 1.0}) {
      const SkyLight light = skyLight(airOf(1e5), towards(sunSine, sunAzimuth), 500);
      ASSERT_TRUE(isSound(light)) << sunSine;
      for (const double sine : kHardSines) {
        for (const double azimuth : {0.0, 1.0, 1.0 + std::numbers::pi})
          ASSERT_TRUE(isSound(skyRadiance(light, towards(sine, azimuth)))) << sunSine << ' ' << sine;
      }
      for (const double side : {1.0, -1.0}) {
        const glm::dvec3 exact = skyRadiance(light, {0, side, 0});
        for (const glm::dvec3& near : {glm::dvec3(1e-17, side, 0), glm::dvec3(-1e-9, side, 1e-9)}) {
          const glm::dvec3 beside = skyRadiance(light, near);
          for (int c = 0; c < 3; ++c)
            ASSERT_TRUE(
                test::holds("S08", test::apart(beside[c], exact[c]), test::atMost(1e-5 * exact[c]), "light"))
                << sunSine;
        }
      }
    }
  }
  const SkyLight noon = skyLight(airOf(1e5), {0, 1, 0}, 500);
  for (const double azimuth : {1.0, 2.0, 3.0}) {
    const glm::dvec3 a = skyRadiance(noon, towards(0.3, 0)), b = skyRadiance(noon, towards(0.3, azimuth));
    for (int c = 0; c < 3; ++c)
      EXPECT_TRUE(test::holds("S08", test::apart(a[c], b[c]), test::atMost(1e-9 * a[c]), "light"));
  }
}

TEST(Stability, S09_aSunFarBelowTheHorizon) {
  // From -12 degrees down to the nadir: sound, each darker than the one before but for the night's own light,
  // and no direct light from 2 to 60 km up that the earth hides.
  double before = 1e30;
  for (const double sun :
       {-6.0, -9.0, -12.0, -15.0, -18.0, -18.001, -20.0, -25.0, -27.0, -40.0, -89.0, -90.0}) {
    const SkyLight light = skyLight(airOf(1e5), directionToSun(sun, 90), 500);
    ASSERT_TRUE(isSound(light)) << sun;
    double sum = 0;
    for (const double sine : {0.0, 0.1, 0.5, 1.0}) {
      for (const double azimuth : {0.0, 1.5, 3.1}) {
        const glm::dvec3 radiance = skyRadiance(light, towards(sine, azimuth));
        ASSERT_TRUE(isSound(radiance));
        for (int c = 0; c < 3; ++c) ASSERT_GE(radiance[c], light.night[c]);
        sum += radiance.y - light.night.y;
      }
    }
    EXPECT_LE(sum, before + 1e-14) << sun;  // rounding of the night's light
    before = sum;
    EXPECT_EQ(sunIlluminance(light, 2000), glm::dvec3(0)) << sun;
    if (sun < -8) {
      EXPECT_EQ(sunIlluminance(light, 60000), glm::dvec3(0)) << sun;
    }
  }
  EXPECT_TRUE(test::holds("S09", before, test::below(1e-9), "light"));
}

TEST(Stability, S10_airWithoutHazeOzoneOrMolecules) {
  // Each may be nothing: sound light; without any of them black sky and the whole sun.
  for (const unsigned which : {1u, 2u, 3u, 4u, 5u, 6u, 7u}) {
    Atmosphere air = airOf(1e5);
    if (which & 1) air.haze = 0;
    if (which & 2) air.ozone = glm::dvec3(0);
    if (which & 4) air.rayleigh = glm::dvec3(0);
    for (const double sun : {40.0, 0.0, -5.0}) {
      const SkyLight light = skyLight(air, directionToSun(sun, 90), 500);
      ASSERT_TRUE(isSound(light)) << which;
      for (const double sine : kHardSines) {
        ASSERT_TRUE(isSound(skyRadiance(light, towards(sine, 1)))) << which;
        ASSERT_TRUE(isSound(airRadiance(light, towards(sine, 1), 1e4))) << which;
      }
      if (which == 7) {
        EXPECT_TRUE(test::holds("S10", glm::length(skyRadiance(light, towards(0.5, 1)) - light.night),
                                test::below(1e-12), "light"));
        if (sun > 0) {
          EXPECT_TRUE(
              test::holds("S10", glm::length(light.sun - light.sunOutside), test::below(1e-3), "light"));
        }
      }
    }
  }
}

TEST(Stability, S11_theEdgesOfTheSkysTables) {
  // At their first and last texels, and between the two rows at the horizon, a table gives the texel itself:
  // nothing is mixed in from beyond an end or across the horizon.
  namespace f64 = core::shared::f64;
  for (const double height : {1.0, 500.0, 12000.0, 4e5}) {
    SkyViews views(airOf(1e5));
    const SkyView view = *views.view(height, 0.2);
    const auto texel = [&](SkyLayer layer, int row, int column) {
      const int index = (static_cast<int>(layer) * f64::kSkyRows + row) * f64::kSkyColumns + column;
      return glm::dvec3(view.texels[static_cast<std::size_t>(index)]);
    };
    const auto expectSame = [&](double sine, double cosAzimuth, int row, int column) {
      for (const SkyLayer layer : {SkyLayer::skyEven, SkyLayer::skyHaze, SkyLayer::left}) {
        const glm::dvec3 a = view.at(layer, sine, cosAzimuth), b = texel(layer, row, column);
        for (int c = 0; c < 3; ++c)
          EXPECT_TRUE(test::holds("S11", test::apart(a[c], b[c]), test::atMost(1e-7 + 1e-5 * b[c]), "light"))
              << height << ' ' << row;
      }
    };
    const int lastColumn = f64::kSkyColumns - 1;
    for (const auto& [cosine, column] : {std::pair{-1.0, 0}, {1.0, lastColumn}}) {
      expectSame(-1, cosine, 0, column);
      expectSame(view.airEnds, cosine, f64::kSkyRows - 1, column);
      expectSame(1, cosine, f64::kSkyRows - 1, column);
      expectSame(view.horizon, cosine, f64::kSkyRowsBelow, column);
      expectSame(std::nextafter(view.horizon, -1), cosine, f64::kSkyRowsBelow - 1, column);
    }
    for (const double distance : {0.0, 1e300, HUGE_VAL}) {
      const glm::dvec3 mean = view.upTo(SkyLayer::airEven, 0.1, 1, distance);
      const auto slice = static_cast<SkyLayer>(static_cast<int>(SkyLayer::airEven) +
                                               (distance > 0 ? f64::kSkySlices - 1 : 0));
      EXPECT_TRUE(test::holds("S11", glm::length(mean - view.at(slice, 0.1, 1)), test::below(1e-12), "light"))
          << distance;
    }
  }
}

}  // namespace
}  // namespace skydrop::sky
