#include <gtest/gtest.h>

#include "support/margin.h"

namespace skydrop {
namespace {

TEST(Stability, C01_phaseFunctionsIntegrateToOneAndAreExactAtTheirEnds) {
  // Over the sphere, by the midpoint rule in the cosine, and the mean cosine is g; straight ahead and back
  // the closed form is (1 + g) / (1 - g)^2 / 4 pi and (1 - g) / (1 + g)^2 / 4 pi, which floats keep within
  // 1e-5.
  EXPECT_TRUE(test::holdsLive("C01"));
}

}  // namespace
}  // namespace skydrop
