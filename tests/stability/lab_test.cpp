// The laboratory where its arithmetic is hard: rows L01 and on.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "skydrop/lab/distance_measure.h"
#include "skydrop/lab/march_measure.h"
#include "skydrop/lab/noise_measure.h"
#include "skydrop/lab/shared.h"
#include "support/margin.h"

namespace skydrop::lab {
namespace {

namespace f32 = core::shared::f32;
namespace f64 = core::shared::f64;
using glm::dvec3;

constexpr int kMethods[] = {f64::kConstantStep, f64::kHalving, f64::kSphereTracing};

TEST(Stability, L01_normalsAreUnitVectorsForEveryEpsilon) {
  // From 1e-1 to 1e-12, in float too, where the difference is lost in rounding: finite, of length 1.
  for (double epsilon = 0.1; epsilon > 0.5e-12; epsilon /= 10) {
    for (const glm::vec3& place : {glm::vec3(1, 0, 0), glm::vec3(0.7f, 0.3f, 0.1f), glm::vec3(1e3f, 2, 5)}) {
      const auto inFloat = f32::normalAt(f32::kTorusScene, 0, place, static_cast<float>(epsilon));
      EXPECT_TRUE(test::holds("L01", test::apart(glm::length(inFloat), 1), test::atMost(1e-5), "of length 1"))
          << epsilon;
      EXPECT_TRUE(test::holds(
          "L01", test::apart(glm::length(f64::normalAt(f64::kTorusScene, 0, dvec3(place), epsilon)), 1),
          test::atMost(1e-12), "of length 1"))
          << epsilon;
    }
    EXPECT_TRUE(test::holds("L01", normalError(epsilon).inDouble, test::atMost(0.05), "rad")) << epsilon;
  }
}

TEST(Stability, L02_raysParallelToFacesNeitherHitNorStall) {
  // Level over the floor and along the box's faces, 1e-3 away: without end for sphere tracing, which must
  // give up within its steps; on the face a hit at once.
  test::noFaults("L02", "violations");
  for (const double gap : {1e-2, 1e-3, 0.0}) {
    const f64::March end = f64::marchAlong(f64::kSphereTracing, f64::kBallScene, 0, dvec3(3, gap, 50),
                                           dvec3(0, 0, -1), f64::make_marchLimits(1, 1e-4, 100), 1000);
    EXPECT_LE(end.steps, 1000);
    EXPECT_EQ(end.state == f64::kHit, gap == 0) << gap;
    EXPECT_TRUE(std::isfinite(end.t));
  }
  const f64::RaySpan beside = f64::raySpanOfBox({2, 0, 0}, {0, 0, 1}, {-1, -1, -1}, {1, 1, 1});
  EXPECT_LE(beside.end, beside.begin);
}

TEST(Stability, L03_softShadowsAndSmoothUnionsTakeZeroAndEndlessWidths) {
  test::noFaults("L03", "violations");
  const double endless = std::numeric_limits<double>::infinity();
  const dvec3 place(2.5, 0, 0), up = glm::normalize(dvec3(-0.3, 1, 0));
  const auto light = [&](double k, double start) {
    return f64::shadeAlong(f64::kShadowScene, 0, place, up, start, 10, k, 64).light;
  };
  EXPECT_EQ(light(endless, 0.02), 1);
  EXPECT_EQ(light(0, 0.02), 0);
  EXPECT_GE(light(7, 0.02), 0);
  // A width of 0 is the union; an endless one lies far below both shapes, finite.
  EXPECT_EQ(f64::smoothUnionOf(1, 2, 0), 1);
  EXPECT_TRUE(std::isfinite(f64::smoothUnionOf(1, 2, endless)));
  EXPECT_LT(f64::smoothUnionOf(1, 2, endless), -1e8);
  EXPECT_EQ(f64::smoothUnionOf(1, 1, 4), 0);  // a quarter of the width
}

TEST(Stability, L04_aStepOfZeroEndsAsAMiss) {
  test::noFaults("L04", "violations");
  for (const int method : kMethods) {
    const f64::March end = f64::marchAlong(method, f64::kBallScene, 0, dvec3(0, 5, 9), dvec3(0, 0, -1),
                                           f64::make_marchLimits(0, 1e-3, 100), 1000000);
    EXPECT_EQ(end.state, f64::kMissed) << method;
    EXPECT_LE(end.steps, 1) << method;
  }
}

TEST(Stability, L05_noStepsAndAMillionStepsAreTaken) {
  for (const int method : kMethods) {
    MarchKnobs knobs;
    knobs.mostSteps = 0;
    EXPECT_EQ(marchError(knobs, method).stepsPerRay, 0) << method;
    // 1e-5 a step for 9 units: close to a million, and the places add up to 1e-9.
    const f64::March end = f64::marchAlong(method, f64::kBallScene, 0, dvec3(0, 1, 10), dvec3(0, 0, -1),
                                           f64::make_marchLimits(1e-5, 1e-6, 100), 1000000);
    EXPECT_EQ(end.state, f64::kHit) << method;
    EXPECT_TRUE(test::holds("L05", test::apart(end.t, 9), test::atMost(2e-5), "m")) << method;
  }
  // In float the places of a constant step drift: 1e6 additions of 1e-5 are 2 % off. They are, and are told.
  const f32::March drifted =
      f32::marchAlong(f32::kConstantStep, f32::kBallScene, 0, glm::vec3(0, 1, 10), glm::vec3(0, 0, -1),
                      f32::make_marchLimits(1e-5f, 0, 100), 1000000);
  EXPECT_TRUE(test::holds("L05", test::apart(drifted.t, 9), test::atMost(0.3), "m"));
}

TEST(Stability, L06_nestedDifferencesCutEverythingAtMostOnce) {
  // a without b without (c without d) ...: within the bounds of its parts, whatever the depth.
  test::noFaults("L06", "violations");
  double nested = 0.3;
  for (int i = 0; i < 1000; ++i) nested = f64::differenceOf(nested, f64::differenceOf(0.25, nested));
  EXPECT_TRUE(std::isfinite(nested));
  EXPECT_GE(nested, 0.3);
  EXPECT_LE(nested, 0.3 + 1e-12);
  // Without itself nothing is left: nowhere inside.
  for (const double d : {-1.0, -0.0, 0.0, 2.0}) EXPECT_GE(f64::differenceOf(d, d), 0);
}

TEST(Stability, L07_hashesAreTheSameInFloatAndDoubleWhereSinesAreNot) {
  // A million cells away: nearly every sine-made number is another one, of the hashes none.
  test::noFaults("L07", "differences");
  const RandomError away = randomError(1e6);
  EXPECT_GT(away.sineApart, 0.9);
  EXPECT_LT(away.sineDistinct, 0.5);
  for (const double from : {0.0, 1e3, 1e6, 1e7, 4e9}) {
    const RandomError error = randomError(from);
    EXPECT_EQ(error.hashApart, 0) << from;
    EXPECT_GT(error.hashDistinct, 0.999) << from;
  }
}

TEST(Stability, L08_periodsOfOneAndTwoTile) {
  for (const int period : {1, 2}) {
    const VoronoiKnobs knobs{.period = period};
    EXPECT_EQ(tileError(knobs, true), 0) << period;
    const auto cells = static_cast<std::uint32_t>(period);
    for (int i = 0; i < 64; ++i) {
      const float y = static_cast<float>(i) / 64;
      // Both borders of the period have the same nodes: within rounding of each other.
      EXPECT_TRUE(test::holds(
          "L08", test::apart(f32::perlinPlane({0, y}, cells, 7), f32::perlinPlane({0.999999f, y}, cells, 7)),
          test::atMost(2e-5), "of 1"));
      EXPECT_TRUE(test::holds(
          "L08", test::apart(f32::nearVoronoi({0, y}, cells, 7), f32::nearVoronoi({0.999999f, y}, cells, 7)),
          test::atMost(2e-5), "of 1"));
      EXPECT_TRUE(std::isfinite(f32::perlinSpace({0.3f, y, 0.9f}, cells, 7)));
    }
  }
}

TEST(Stability, L09_negativeCellsTileBitForBit) {
  // Floored remainders; truncated ones tear.
  test::noFaults("L09", "violations");
  for (const std::int64_t period : {1, 2, 3, 7}) {
    const VoronoiKnobs knobs{.period = period};
    EXPECT_EQ(tileError(knobs, true), 0) << period;
    if (period > 1) {
      EXPECT_GT(tileError(knobs, false), 0.1) << period;
    }
    for (int cell = -20; cell <= 20; ++cell) {
      const int left = f32::flooredRemainder(cell, static_cast<int>(period));
      EXPECT_GE(left, 0);
      EXPECT_LT(left, period);
      EXPECT_EQ((cell - left) % period, 0);
    }
  }
}

}  // namespace
}  // namespace skydrop::lab
