// The aircraft's lamps: from where they are seen, how bright, when they flash, and what a spot lights.
#include "skydrop/render/models/aircraft_lamps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <string>

#include "skydrop/core/shared_lamps.h"
#include "skydrop/render/models/landing_light_pass.h"
#include "support/margin.h"

namespace skydrop::render {
namespace {

namespace f32 = core::shared::f32;
namespace f64 = core::shared::f64;

game::AircraftSnapshot flying() {
  game::AircraftSnapshot aircraft;
  aircraft.present = true;
  aircraft.position = {3000, 700, -5000};
  aircraft.heightAboveGround = 40;
  return aircraft;  // nose to -z
}

// cd by lamp, from 500 m away at a bearing: degrees right of the nose, and above.
std::map<std::string, double> seenFrom(double bearing, double elevation, double seconds = 0) {
  const game::AircraftSnapshot aircraft = flying();
  const double b = bearing * std::numbers::pi / 180, e = elevation * std::numbers::pi / 180;
  const glm::dvec3 eye = aircraft.position + 500.0 * glm::dvec3(std::sin(b) * std::cos(e), std::sin(e),
                                                                -std::cos(b) * std::cos(e));
  std::map<std::string, double> lamps;
  for (const LitLamp& lamp : litLamps(aircraft, {}, seconds, eye))
    lamps[std::string(lamp.name)] = lamp.towardsEye;
  return lamps;
}

TEST(AircraftLamps, positionLightsAreSeenInTheirSectors) {
  // (The eye is level with the aircraft's middle, not with each lamp: a hundredth.)
  // Red from ahead to 110 degrees on the left, green on the right, white 70 degrees to both sides of straight
  // behind, with at least what FAR 23.1391 asks for (a degree and more within); beyond a sector no more than
  // the overlaps of FAR 23.1395.
  for (double bearing = -180; bearing <= 180; bearing += 1) {
    auto lamps = seenFrom(bearing, 0);
    const double off = std::abs(bearing);
    const double least = off <= 10 ? 40 : off <= 20 ? 30 : off <= 110 ? 5 : 0;
    const bool isLeft = bearing < 0;
    if (off > 1 && off < 108) {
      EXPECT_GE(lamps[isLeft ? "left" : "right"], 0.99 * least) << bearing;
    }
    if (off > 2) {
      EXPECT_LE(lamps[isLeft ? "right" : "left"], off < 11 ? 10 : 1.001) << bearing;
    }
    if (off > 122) {
      EXPECT_LE(lamps["left"], 1.001) << bearing;
      EXPECT_LE(lamps["right"], 1.001) << bearing;
    }
    if (off > 112) {
      EXPECT_GE(lamps["tail"], 0.99 * 20) << bearing;
    }
    if (off < 98) {
      EXPECT_LE(lamps["tail"], 1.001) << bearing;
    }
  }
}

TEST(AircraftLamps, theyFadeUpwardsAndDownwardsAsTheyMust) {
  // FAR 23.1393: of the level intensity at least these shares.
  EXPECT_EQ(verticalShare(0), 1);
  for (const auto& [degrees, share] :
       {std::pair{4.9, 0.9}, {9.9, 0.8}, {14.9, 0.7}, {19.9, 0.5}, {29.9, 0.3}, {39.9, 0.1}, {89.0, 0.05}}) {
    EXPECT_GE(verticalShare(degrees), share) << degrees;
    EXPECT_EQ(verticalShare(-degrees), verticalShare(degrees)) << degrees;
  }
}

TEST(AircraftLamps, antiCollisionLightsFlashAsOftenAsTheSettingSays) {
  // Counted over ten minutes at 60 frames a second: beacon once and strobes twice in each period, and none
  // falls between two frames.
  for (const double rate : {40.0, 48.0, 100.0}) {
    int beacons = 0, pulses = 0;
    double beacon = 0, strobe = 0, mostInPulse = 0, leastPeak = 1;
    for (int frame = 1; frame <= 600 * 60; ++frame) {
      const double phase = flashPhase(frame / 60.0, rate);
      const double b = beaconShare(phase, 60 / rate), s = strobeShare(phase, 60 / rate);
      beacons += b > 0 && beacon == 0;
      pulses += s > 0 && strobe == 0;
      if (s == 0 && strobe > 0) leastPeak = std::min(leastPeak, mostInPulse);
      mostInPulse = s == 0 ? 0 : std::max(mostInPulse, s);
      beacon = b;
      strobe = s;
    }
    EXPECT_NEAR(beacons, 10 * rate, 1) << rate;
    EXPECT_NEAR(pulses, 20 * rate, 2) << rate;
    EXPECT_GT(leastPeak, 0.7) << rate;
  }
}

TEST(AircraftLamps, S72_flashesAreFiniteAtAnyTime) {
  test::noFaults("S72", "values that are not finite");
  for (const double seconds : {-1e9, -0.25, 0.0, 1e15, 1e300, std::nan("")}) {
    const double phase = flashPhase(seconds, 48);
    EXPECT_TRUE(phase >= 0 && phase < 1) << seconds;
    EXPECT_TRUE(std::isfinite(beaconShare(phase, 1.25) + strobeShare(phase, 1.25))) << seconds;
  }
}

TEST(AircraftLamps, aWreckIsDarkAndSoIsOneWithoutBrightness) {
  game::AircraftSnapshot aircraft = flying();
  EXPECT_EQ(litLamps(aircraft, {.brightness = 0}, 0, {}).size(), 0u);
  aircraft.crashed = true;
  EXPECT_EQ(litLamps(aircraft, {}, 0, {}).size(), 0u);
  EXPECT_EQ(cabinLamp(aircraft, {}).towardsAircraft, 0);
}

TEST(AircraftLamps, onTheAircraftTheyReadAtNightAndBleachByDay) {
  // A metre away on white, after exposure: by day under a five-hundredth of white, at night bounded.
  game::AircraftSnapshot aircraft = flying();
  View view;
  view.position = aircraft.position + glm::dvec3(0, 3, 15);
  const auto lamps = litLamps(aircraft, {}, 0, view.position);
  const auto brightest = [&](double exposure) {
    double most = 0;
    for (const glm::vec4& light : lampsOnModel(view, lamps, exposure).lights)
      most = std::max(most, static_cast<double>(std::max({light.x, light.y, light.z})));
    return most / std::numbers::pi;
  };
  RenderSettings settings;
  const double day = skyLight(settings, 700).exposure;
  settings.sun.elevationDegrees = -20;
  const double night = skyLight(settings, 700).exposure;
  EXPECT_LT(brightest(day), 0.002);
  EXPECT_GT(brightest(night), 0.2);
  EXPECT_LT(brightest(1e9), 2);
}

TEST(SpotLight, halfOfItIsLeftAtHalfTheBeamsWidth) {
  // Against the definition, and float against double over the whole sphere, within 2e-6 of the peak.
  const auto share = [](double angle, double half) {
    return f64::spotShare({0, 1, 0}, {std::sin(angle), std::cos(angle), 0}, half);
  };
  for (const double half : {0.03, 0.12, 0.35}) {
    EXPECT_NEAR(share(0, half), 1, 1e-12);
    EXPECT_NEAR(share(half, half), 0.5, 0.01);
    EXPECT_EQ(share(2, half), 0);
    for (double angle = 0; angle < 3.14; angle += 0.01) {
      const f32::Vec3 ray(static_cast<float>(std::sin(angle)), static_cast<float>(std::cos(angle)), 0);
      EXPECT_NEAR(f32::spotShare({0, 1, 0}, ray, static_cast<float>(half)), share(angle, half), 2e-6);
    }
  }
}

TEST(SpotLight, S73_illuminanceIsFiniteAtAndBehindTheLamp) {
  // Inverse square from 0.1 m on; within the lens, at it, behind it and at 1e6 m it is finite and not
  // negative.
  const glm::dvec3 up(0, 1, 0), axis(0, -1, 0);
  EXPECT_TRUE(test::holds("S73", test::apart(f64::spotIlluminance({0, 100, 0}, up, axis, 0.1), 1e-4),
                          test::atMost(1e-9), "lx"));
  EXPECT_TRUE(test::holds("S73", test::apart(f64::spotIlluminance({0, 200, 0}, up, axis, 0.1), 0.25e-4),
                          test::atMost(1e-9), "lx"));
  for (const double height : {0.0, 1e-30, 1e-3, 0.1, -5.0, 1e6, 1e18}) {
    const double exact = f64::spotIlluminance({0, height, 0}, up, axis, 0.1);
    const float single =
        f32::spotIlluminance({0, static_cast<float>(std::min(height, 1e6)), 0}, {0, 1, 0}, {0, -1, 0}, 0.1f);
    EXPECT_TRUE(std::isfinite(exact) && exact >= 0) << height;
    EXPECT_TRUE(std::isfinite(single) && single >= 0) << height;
  }
  for (const double degrees2 : {0.0, 1e-12, 1.0, 1e6, 1e30})
    EXPECT_TRUE(std::isfinite(f64::glareShape(degrees2, 3)) && f64::glareShape(degrees2, 3) >= 0) << degrees2;
}

TEST(LandingLight, itPointsAheadAndBelowTheNose) {
  const SpotLight spot = landingSpot(flying(), {.tiltDegrees = 10});
  EXPECT_NEAR(glm::length(spot.axis), 1, 1e-12);
  EXPECT_NEAR(spot.axis.y, -std::sin(10 * std::numbers::pi / 180), 1e-12);
  EXPECT_LT(spot.axis.z, -0.98);
  EXPECT_LT(spot.position.z, flying().position.z - 2);
  EXPECT_NEAR(glm::dot(spot.intensity, glm::dvec3(0.2126, 0.7152, 0.0722)), 250, 2) << "kcd";
}

TEST(LandingLight, theSpotIsBoundedAtNightAndPhysicalByDay) {
  const SpotLight spot = landingSpot(flying(), {});
  EXPECT_NEAR(shownShareOf(spot, 40, 0.08), 1, 1e-3);
  for (const double height : {0.0, 1.0, 40.0, 300.0, 1e5}) {
    const double share = shownShareOf(spot, height, 1e5);
    EXPECT_TRUE(share > 0 && share <= 1) << height;
  }
  EXPECT_LT(shownShareOf(spot, 20, 1e5), 0.1);
}

}  // namespace
}  // namespace skydrop::render
