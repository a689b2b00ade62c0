// What the needles of the cockpit show.
#include "skydrop/ui/instruments.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "support/margin.h"

namespace skydrop::ui {
namespace {

constexpr double kPi = std::numbers::pi, kDegrees = 180 / kPi;
constexpr double kBad[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity()};

TEST(Instruments, airspeedRunsFromLowerLeftToLowerRight) {
  EXPECT_NEAR(airspeedNeedle(0) * kDegrees, -135, 1e-9);
  EXPECT_NEAR(airspeedNeedle(60) * kDegrees, 0, 1e-9);
  EXPECT_NEAR(airspeedNeedle(120) * kDegrees, 135, 1e-9);
  EXPECT_EQ(airspeedNeedle(500), airspeedNeedle(120));
  EXPECT_EQ(airspeedNeedle(-30), airspeedNeedle(0));
}

TEST(Instruments, theAltimeterHasTwoNeedlesLikeAClock) {
  const AltimeterNeedles needles = altimeterNeedles(2250);
  EXPECT_NEAR(needles.hundreds * kDegrees, 90, 1e-9);
  EXPECT_NEAR(needles.thousands * kDegrees, 81, 1e-9);
  EXPECT_NEAR(altimeterNeedles(-250).hundreds * kDegrees, 270, 1e-9);  // below the sea
  EXPECT_EQ(altimeterNeedles(0).hundreds, 0);
}

TEST(Instruments, theCardTurnsAgainstTheHeading) {
  EXPECT_EQ(compassCard(0), 0);
  EXPECT_NEAR(compassCard(kPi / 2) * kDegrees, -90, 1e-9);
  EXPECT_NEAR(compassCard(-kPi / 2) * kDegrees, -270, 1e-9);
}

TEST(Instruments, climbPointsUpAndSinkDown) {
  EXPECT_NEAR(variometerNeedle(0) * kDegrees, -90, 1e-9);
  EXPECT_NEAR(variometerNeedle(12) * kDegrees, 0, 1e-9);
  EXPECT_NEAR(variometerNeedle(-12) * kDegrees, -180, 1e-9);
  EXPECT_NEAR(variometerNeedle(99) * kDegrees, 60, 1e-9);
  EXPECT_NEAR(engineNeedle(0) * kDegrees, -135, 1e-9);
  EXPECT_NEAR(engineNeedle(1) * kDegrees, 135, 1e-9);
}

TEST(Instruments, theHorizonSinksWithANoseUpAndLeansAgainstTheBank) {
  EXPECT_EQ(horizonLine(0, 0).below, 0);
  EXPECT_GT(horizonLine(0.2, 0).below, 0);
  EXPECT_LT(horizonLine(-0.2, 0).below, 0);
  EXPECT_EQ(horizonLine(kPi / 2, 0).below, 1);
  EXPECT_NEAR(horizonLine(0, 0.5).turnRad, -0.5, 1e-12);
  EXPECT_NEAR(horizonLine(0, kPi).turnRad, kPi, 1e-9);
}

TEST(Instruments, G04_readingsThatAreNoNumbersCountAsNought) {
  test::noFaults("G04", "needles without a place");
  for (const double bad : kBad) {
    EXPECT_EQ(airspeedNeedle(bad), airspeedNeedle(0));
    EXPECT_EQ(altimeterNeedles(bad).hundreds, 0);
    EXPECT_EQ(compassCard(bad), 0);
    EXPECT_EQ(variometerNeedle(bad), variometerNeedle(0));
    EXPECT_EQ(engineNeedle(bad), engineNeedle(0));
    EXPECT_EQ(horizonLine(bad, bad).below, 0);
    EXPECT_EQ(horizonLine(bad, bad).turnRad, 0);
    game::Snapshot snapshot;
    snapshot.aircraft.present = true;
    snapshot.aircraft.airspeedMps = snapshot.aircraft.position.y = snapshot.aircraft.velocity.y = bad;
    EXPECT_EQ(readingsOf(snapshot).altitudeM, 0);
    EXPECT_EQ(readingsOf(snapshot).climbMps, 0);
  }
  for (const double huge : {1e300, -1e300, 1e17}) {
    EXPECT_TRUE(std::isfinite(altimeterNeedles(huge).hundreds));
    EXPECT_GE(altimeterNeedles(huge).hundreds, 0);
    EXPECT_LT(altimeterNeedles(huge).hundreds, 2 * kPi);
    EXPECT_GT(compassCard(huge), -2 * kPi);
  }
}

}  // namespace
}  // namespace skydrop::ui
