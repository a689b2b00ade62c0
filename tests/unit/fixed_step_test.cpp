#include "skydrop/core/fixed_step.h"

#include <gtest/gtest.h>

namespace skydrop::core {
namespace {

TEST(FixedStep, framesOfAnyLengthAddUpToTheSameNumberOfSteps) {
  // Ten seconds in frames of 30, 60, 144 and 1000 Hz make 1200 steps, give or take the one that is under way.
  for (const int rate : {30, 60, 144, 1000}) {
    FixedStep clock;
    int steps = 0;
    for (int frame = 0; frame < 10 * rate; ++frame) steps += clock.advance(1.0 / rate);
    EXPECT_NEAR(steps, 1200, 1) << rate;
    EXPECT_EQ(clock.stepCount(), static_cast<std::uint64_t>(steps));
  }
}

TEST(FixedStep, alphaIsTheShareOfTheStepThatIsUnderWay) {
  // A frame of a step and a half leaves half a step, which the next half a step completes.
  FixedStep clock;
  EXPECT_EQ(clock.advance(1.5 / 120), 1);
  EXPECT_NEAR(clock.alpha(), 0.5, 1e-12);  // steps; rounding of 1.5/120*120
  EXPECT_EQ(clock.advance(0.51 / 120), 1);
  EXPECT_LT(clock.alpha(), 0.02);
  clock.discardPending();
  EXPECT_EQ(clock.alpha(), 0);
}

}  // namespace
}  // namespace skydrop::core
