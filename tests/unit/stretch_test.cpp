#include "render/frame/stretch.h"

#include <gtest/gtest.h>

#include "skydrop/core/shared.h"

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

TEST(Stretch, ofALargerPictureAPixelShowsTheMeanOfWhatItsSamplesShow) {
  // A bright sample among three dark ones weighs as the screen shows it, not as the light that it is.
  const std::vector<float> bright = {0.1f, 0.1f, 0.1f, 8, 8, 8, 0.1f, 0.1f, 0.1f, 0.1f, 0.1f, 0.1f};
  const std::vector<float> one = stretched({2, 2, bright}, {1, 1});
  namespace shared = core::shared::f32;
  const auto shown = [](float light) { return shared::toneMap(glm::vec3(light)).y; };
  EXPECT_NEAR(shown(one[1]), 0.75f * shown(0.1f) + 0.25f * shown(8), 2e-4f);
  EXPECT_LT(one[1], 1);
  // Of pixels that are alike nothing changes, whatever the sizes.
  for (const int side : {3, 4, 7}) {
    const std::vector<float> even(static_cast<std::size_t>(3 * side * side), 0.3f);
    for (const float light : stretched({side, side, even}, {2, 2})) EXPECT_NEAR(light, 0.3f, 1e-5f);
  }
}

TEST(Stretch, aPixelsSamplesAreAsManyAsTheSceneHasForIt) {
  EXPECT_EQ(samplesAcross({160, 90}, {320, 180}), 1);
  EXPECT_EQ(samplesAcross({320, 180}, {320, 180}), 1);
  EXPECT_EQ(samplesAcross({352, 198}, {320, 180}), 2);
  EXPECT_EQ(samplesAcross({1280, 720}, {320, 180}), 4);
}

}  // namespace
}  // namespace skydrop::render
