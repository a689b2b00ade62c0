#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "skydrop/core/fixed_step.h"
#include "skydrop/core/guards.h"
#include "support/margin.h"

namespace skydrop::core {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Stability, P12_framesOfNoTimeOrNonsenseAdvanceNothing) {
  // 0, negative, NaN and infinite frame times leave the clock as it is, the part of a step under way
  // included.
  test::noFaults("P12", "violations");
  FixedStep clock;
  clock.advance(1.5 / 120);
  const double alpha = clock.alpha();
  resetGuardCounts();
  for (const double dt : {0.0, -0.0, -5.0, kNaN, kInfinity, -kInfinity}) EXPECT_EQ(clock.advance(dt), 0);
  EXPECT_EQ(clock.alpha(), alpha);
  EXPECT_EQ(clock.stepCount(), 1u);
  EXPECT_EQ(guardCount(Guard::clockStep), 3u);
}

TEST(Stability, P12_aHitchOfTenSecondsAdvancesAQuarterOfASecond) {
  // 10 s in one frame are 30 steps, whatever part of a step was under way before.
  test::noFaults("P12", "violations");
  FixedStep clock;
  clock.advance(0.9 / 120);
  EXPECT_EQ(clock.advance(10), 30);
  EXPECT_EQ(clock.advance(1e300), 30);
}

TEST(Stability, P14_aStallWhileLoadingIsNotReplayed) {
  // 6 s of loading and then 2 s at 60 Hz simulate at most 2.25 s in all, not 7.8.
  test::noFaults("P14", "violations");
  FixedStep clock;
  clock.advance(6);
  for (int frame = 0; frame < 120; ++frame) clock.advance(1.0 / 60);
  EXPECT_LE(clock.simulatedSeconds(), 2.25);
  EXPECT_GE(clock.simulatedSeconds(), 2.24);
}

TEST(Stability, P15_stepsSlowerThanRealTimeSlowTheGameAndNothingElse) {
  // Each step costs 20 ms, more than twice what it simulates. Frames settle at 30 steps (.6 s) instead of
  // growing, and simulated time goes on at the rate that the machine can do.
  FixedStep clock;
  double frameSeconds = 1.0 / 60, longest = 0, real = 0;
  for (int frame = 0; frame < 200; ++frame) {
    const int steps = clock.advance(frameSeconds);
    frameSeconds = 0.001 + steps * 0.020;
    longest = std::max(longest, frameSeconds);
    real += frameSeconds;
  }
  EXPECT_LE(longest, 0.001 + 30 * 0.020);
  EXPECT_TRUE(test::holds("P15", test::apart(clock.simulatedSeconds() / real, (1.0 / 120) / 0.020),
                          test::atMost(0.01), "relative"));  // a frame's own millisecond
}

TEST(Stability, P16_stepsAreAsLongAfterTenMillionSecondsAndNoneIsLost) {
  // Time is a count of steps: after 1e7 s the time from one step to the next is right within a microsecond. 3
  // million frames of 1/144 s count the exact number of them, give or take the step under way.
  EXPECT_TRUE(test::holdsLive("P16"));
  EXPECT_EQ(FixedStep::secondsOf(1'200'000'000), 1e7);
}

}  // namespace
}  // namespace skydrop::core
