#include "render/frame/stretch.h"

#include <gtest/gtest.h>

namespace skydrop::render {
namespace {

TEST(Stretch, aPictureOfTheSameSizeStaysAsItIs) {
  const std::vector<float> light = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
  EXPECT_EQ(stretched({2, 2, light}, {2, 2}), light);
}

TEST(Stretch, isLinearBetweenCentresAndContinuesEdges) {
  // Two pixels of 0 and 8 to eight: centres at an eighth of the way, outside of the first and last as those
  // are.
  const std::vector<float> wide = stretched({2, 1, {0, 0, 0, 8, 80, 800}}, {8, 1});
  const float expected[] = {0, 0, 1, 3, 5, 7, 8, 8};
  ASSERT_EQ(wide.size(), 24u);
  for (std::size_t x = 0; x < 8; ++x) {
    EXPECT_FLOAT_EQ(wide[3 * x], expected[x]) << x;
    EXPECT_FLOAT_EQ(wide[3 * x + 2], 100 * expected[x]) << x;
  }
  const std::vector<float> high = stretched({1, 2, {0, 0, 0, 8, 8, 8}}, {1, 8});
  for (std::size_t y = 0; y < 8; ++y) EXPECT_FLOAT_EQ(high[3 * y], expected[y]) << y;
}

}  // namespace
}  // namespace skydrop::render
