#include "support/image_compare.h"

#include "support/temporary_folder.h"

namespace skydrop::test {
namespace {

core::Image gradient() {
  core::Image image(32, 16);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 32; ++x) {
      for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] = static_cast<std::uint8_t>(60 + 4 * x + y * (c + 1));
      image.pixel(x, y)[3] = 255;
    }
  }
  return image;
}

TEST(ImageCompare, measuresLargestAndMeanDifference) {
  // One channel of one pixel off by 12: largest 12, mean 12 / (512 pixels * 3).
  core::Image changed = gradient();
  changed.pixel(5, 5)[1] = static_cast<std::uint8_t>(changed.pixel(5, 5)[1] + 12);
  const ImageDifference difference = compareImages(gradient(), changed);
  EXPECT_EQ(difference.largest, 12);
  EXPECT_DOUBLE_EQ(difference.mean, 12.0 / (512 * 3));
  EXPECT_DOUBLE_EQ(difference.shareAbove2, 1.0 / 512);
  EXPECT_TRUE(within(difference, {12, 0.01}));
  EXPECT_FALSE(within(difference, {11, 0.01}));
  EXPECT_FALSE(within(difference, {12, 0.001}));
}

TEST(ImageCompare, seesAShiftOfOnePixelAndTwoPercentOfBrightness) {
  // Both make a picture with contrast differ beyond the limits that goldens use.
  const ImageLimits limits{2, 0.2};
  EXPECT_FALSE(within(compareImages(gradient(), shiftedByOnePixel(gradient())), limits));
  EXPECT_FALSE(within(compareImages(gradient(), brightened(gradient(), 1.02)), limits));
  EXPECT_TRUE(within(compareImages(gradient(), gradient()), {0, 0}));
}

TEST(ImageCompare, otherSizeNeverMatches) {
  // A picture of another size differs whatever the limits.
  EXPECT_FALSE(within(compareImages(gradient(), core::Image(16, 32)), {255, 255}));
}

TEST(ImageCompare, missingReferenceFails) {
  // A golden without its reference is a failure, not a pass.
  const TemporaryFolder folder;
  if (std::getenv("SKYDROP_UPDATE_GOLDENS")) GTEST_SKIP() << "blessing";
  EXPECT_FALSE(matchesReference(gradient(), folder.path() / "absent.png", {0, 0}));
}

}  // namespace
}  // namespace skydrop::test
