#include "skydrop/game/controls.h"

#include <gtest/gtest.h>

#include <cmath>

namespace skydrop::game {
namespace {

TEST(Controls, roundingIsIdempotentAndKeepsCentreAndStops) {
  // 0 and the stops survive exactly, anything between is off by at most half of 1/127, and rounding twice is
  // rounding once.
  for (double value = -1; value <= 1; value += 0.001) {
    const Controls once = quantised({.pitch = value, .roll = -value, .yaw = value});
    EXPECT_NEAR(once.pitch, value, 0.5 / 127 + 1e-12);
    EXPECT_EQ(quantised(once), once);
  }
  const Controls ends = quantised({.thrust = 1, .brake = 0, .pitch = 1, .roll = -1, .yaw = 0, .drop = true});
  EXPECT_EQ(ends, (Controls{.thrust = 1, .brake = 0, .pitch = 1, .roll = -1, .yaw = 0, .drop = true}));
}

TEST(Controls, leftAndRightRoundAlike) {
  // A stick pushed as far left as right gives the same deflection, so no key pair drifts.
  for (int i = -508; i <= 508; ++i) {  // quarters of a step: halves are where rounding could lean to one side
    EXPECT_EQ(quantised({.roll = i / 508.0}).roll, -quantised({.roll = -i / 508.0}).roll);
  }
}

TEST(Controls, leversHaveNoNegativeSide) {
  // Thrust and brake below 0 are 0; beyond 1 they are 1.
  EXPECT_EQ(quantised({.thrust = -1, .brake = -0.3}), Controls{});
  EXPECT_EQ(quantised({.thrust = 7}).thrust, 1);
}

}  // namespace
}  // namespace skydrop::game
