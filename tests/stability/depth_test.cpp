#include <gtest/gtest.h>

#include <initializer_list>

#include "skydrop/core/shared.h"
#include "support/margin.h"

namespace skydrop::core::shared {
namespace {

TEST(Stability, C14_distanceComesBackFromDepth) {
  // From 1 m to 1e7 m through a float depth: within 1e-4 relative, corners of the picture included; nothing
  // at depth 0.
  for (double distance = 1; distance <= 1e7; distance *= 1.3) {
    for (const double rayScale : {1.0, 1.53}) {
      const float depth = f32::depthOfViewZ(static_cast<float>(distance / rayScale), 0.1f);
      const float back = f32::distanceOfDepth(depth, 0.1f, static_cast<float>(rayScale));
      EXPECT_TRUE(test::holds("C14", test::apart(static_cast<double>(back) / distance, 1), test::atMost(1e-4),
                              "relative"));
    }
  }
  EXPECT_EQ(f32::viewZOfDepth(0, 0.1f), 1e30f);
  EXPECT_EQ(f32::distanceOfDepth(0, 0.1f, 1.5f), 1e30f);
}

}  // namespace
}  // namespace skydrop::core::shared
