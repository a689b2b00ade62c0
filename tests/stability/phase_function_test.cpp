#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <numbers>

#include "skydrop/core/shared.h"
#include "support/margin.h"

namespace skydrop::core::shared {
namespace {

constexpr double kTau = 2 * std::numbers::pi;

TEST(Stability, C01_phaseFunctionsIntegrateToOne) {
  // Over the sphere, by the midpoint rule in the cosine (2e5 steps: 1e-5 for g up to 0.95); the mean cosine
  // is g.
  constexpr int kSteps = 200000;
  for (const double g : {-0.9, 0.0, 0.5, 0.76, 0.95, 1.0}) {
    double sum = 0, mean = 0;
    for (int i = 0; i < kSteps; ++i) {
      const double cosine = -1 + 2 * (i + 0.5) / kSteps;
      sum += f64::henyeyGreenstein(cosine, g) * kTau * 2 / kSteps;
      mean += f64::henyeyGreenstein(cosine, g) * cosine * kTau * 2 / kSteps;
    }
    EXPECT_TRUE(test::holds("C01", test::apart(sum, 1), test::atMost(1e-4), "of 1")) << g;
    EXPECT_TRUE(test::holds("C01", test::apart(mean, std::min(g, 0.95)), test::atMost(1e-4), "of 1")) << g;
  }
  double rayleigh = 0;
  for (int i = 0; i < kSteps; ++i)
    rayleigh += f64::rayleighPhase(-1 + 2 * (i + 0.5) / kSteps) * kTau * 2 / kSteps;
  EXPECT_TRUE(test::holds("C01", test::apart(rayleigh, 1), test::atMost(1e-6), "of 1"));
}

TEST(Stability, C01_phaseFunctionIsExactStraightAheadAndBack) {
  // At the ends the closed form is (1 + g) / (1 - g)^2 / 4 pi and (1 - g) / (1 + g)^2 / 4 pi: float within
  // 1e-5.
  for (const double g : {0.1, 0.76, 0.9, 0.95}) {
    const double ahead = (1 + g) / ((1 - g) * (1 - g)) / (2 * kTau),
                 back = (1 - g) / ((1 + g) * (1 + g)) / (2 * kTau);
    EXPECT_TRUE(test::holds(
        "C01", test::apart(static_cast<double>(f32::henyeyGreenstein(1, static_cast<float>(g))) / ahead, 1),
        test::atMost(1e-5), "relative"));
    EXPECT_TRUE(test::holds(
        "C01", test::apart(static_cast<double>(f32::henyeyGreenstein(-1, static_cast<float>(g))) / back, 1),
        test::atMost(1e-5), "relative"));
  }
}

}  // namespace
}  // namespace skydrop::core::shared
