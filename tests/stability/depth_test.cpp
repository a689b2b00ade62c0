#include <gtest/gtest.h>

#include "skydrop/core/shared.h"
#include "support/margin.h"

namespace skydrop::core::shared {
namespace {

TEST(Stability, C14_distanceComesBackFromDepth) {
  // From 1 m to 1e7 m through a float depth: within 1e-4 relative, corners of the picture included; nothing
  // at depth 0.
  EXPECT_TRUE(test::holdsLive("C14"));
  EXPECT_EQ(f32::viewZOfDepth(0, 0.1f), 1e30f);
  EXPECT_EQ(f32::distanceOfDepth(0, 0.1f, 1.5f), 1e30f);
}

}  // namespace
}  // namespace skydrop::core::shared
