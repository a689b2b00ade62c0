// The laboratory's ways to march, against the closed form of their scene.
#include <gtest/gtest.h>

#include <cmath>

#include "skydrop/lab/march_measure.h"

namespace skydrop::lab {
namespace {

namespace f64 = core::shared::f64;
using glm::dvec3;

MarchKnobs exact(double stride, double tolerance) {
  MarchKnobs knobs;
  knobs.stride = stride;
  knobs.tolerance = tolerance;
  knobs.mostSteps = 1000000;
  return knobs;
}

TEST(LabMarch, errorOfAConstantStepIsUpToTheStepAndShrinksWithIt) {
  // First order: the mean is half a step (a third to two thirds, as rays share their grid), the largest a
  // whole.
  for (const double stride : {0.1, 0.01, 0.001}) {
    const MarchError error = marchError(exact(stride, 0), f64::kConstantStep);
    EXPECT_LE(error.largestError, stride * (1 + 1e-9)) << stride;
    EXPECT_GT(error.meanError, stride / 3) << stride;
    EXPECT_LT(error.meanError, stride / 1.5) << stride;
  }
}

TEST(LabMarch, halvingEndsWithinTwoOfItsLastSteps) {
  // However long the first step is, a few steps more for each digit.
  double before = 0;
  for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8}) {
    const MarchError error = marchError(exact(0.25, tolerance), f64::kHalving);
    EXPECT_LE(error.largestError, 2 * tolerance) << tolerance;
    if (before > 0) {
      EXPECT_LT(error.stepsPerRay - before, 20) << tolerance;
    }
    before = error.stepsPerRay;
  }
}

TEST(LabMarch, sphereTracingConvergesWithItsTolerance) {
  // First order in the tolerance, at a few steps for each digit.
  double before = 0;
  for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8}) {
    const MarchError error = marchError(exact(1, tolerance), f64::kSphereTracing);
    EXPECT_LT(error.meanError, 3 * tolerance) << tolerance;
    if (before > 0) {
      EXPECT_LT(error.stepsPerRay - before, 12) << tolerance;
    }
    before = error.stepsPerRay;
  }
}

TEST(LabMarch, sphereTracingNeedsAFifthOfTheStepsOfAConstantStepAtEqualError) {
  // Promised for every error from the rough one on: counted, not timed.
  for (const double tolerance : {0.02, 0.005, 1e-3, 1e-4}) {
    const MarchError traced = marchError(exact(1, tolerance), f64::kSphereTracing);
    // Half a step is the mean error of a constant one.
    const MarchError constant = marchError(exact(2 * traced.meanError, 0), f64::kConstantStep);
    EXPECT_NEAR(constant.meanError, traced.meanError, 0.35 * traced.meanError);
    EXPECT_LE(5 * traced.stepsPerRay, constant.stepsPerRay) << tolerance;
  }
}

TEST(LabMarch, floatEndsWhereDoubleDoes) {
  // Down to the rounding of places about 6 units away: 1e-6.
  for (const int method : {f64::kConstantStep, f64::kHalving, f64::kSphereTracing}) {
    const MarchKnobs knobs = exact(0.1, 1e-3);
    EXPECT_NEAR(marchErrorInFloat(knobs, method).meanError, marchError(knobs, method).meanError, 2e-3)
        << method;
  }
}

TEST(LabMarch, raysThatStartInsideOrOnTheSurfaceEndThere) {
  for (const int method : {f64::kConstantStep, f64::kHalving, f64::kSphereTracing}) {
    for (const dvec3& start :
         {dvec3(0, 1, 0), dvec3(0, 0.5, 0.2), dvec3(0, 2, 0), dvec3(4, 0, 0), dvec3(1, -3, 2)}) {
      const f64::March end = f64::marchAlong(method, f64::kBallScene, 0, start, dvec3(0, 0.6, 0.8),
                                             f64::make_marchLimits(0.1, 1e-3, 10), 1000);
      EXPECT_EQ(end.state, f64::kHit) << method << ' ' << start.y;
      EXPECT_EQ(end.t, 0) << method << ' ' << start.y;
      EXPECT_EQ(f64::rayToBallScene(start, dvec3(0, 0.6, 0.8)), 0);
    }
  }
}

TEST(LabMarch, raysThatMissOrPassASurfaceCloselyAreNoHits) {
  // Upwards past the ball, 0.01 beside it and level at a height of 2.01.
  for (const int method : {f64::kConstantStep, f64::kHalving, f64::kSphereTracing}) {
    for (const auto& [start, direction] :
         {std::pair(dvec3(0, 2.01, 5), dvec3(0, 0, -1)), std::pair(dvec3(1.01, 0.5, 0), dvec3(0, 1, 0)),
          std::pair(dvec3(0, 3, 0), dvec3(0, 1, 0))}) {
      const f64::March end = f64::marchAlong(method, f64::kBallScene, 0, start, direction,
                                             f64::make_marchLimits(0.1, 1e-3, 20), 100000);
      EXPECT_EQ(end.state, f64::kMissed) << method << ' ' << start.y;
      EXPECT_LT(f64::rayToBallScene(start, direction), 0);
    }
  }
}

}  // namespace
}  // namespace skydrop::lab
