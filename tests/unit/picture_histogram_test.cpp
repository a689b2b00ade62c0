// How far two pictures are apart in brightness, hue and colour.
#include "skydrop/accuracy/picture_histogram.h"

#include <gtest/gtest.h>

#include "skydrop/core/error.h"

namespace skydrop::accuracy {
namespace {

core::Image plain(int red, int green, int blue) {
  core::Image image(8, 4);
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    image.rgba[i] = static_cast<std::uint8_t>(red), image.rgba[i + 1] = static_cast<std::uint8_t>(green);
    image.rgba[i + 2] = static_cast<std::uint8_t>(blue), image.rgba[i + 3] = 255;
  }
  return image;
}

TEST(PictureHistogram, equalPicturesAreNoDistanceApartAndBlackAndWhiteTheWholeRange) {
  const PictureHistogram black = histogramOf(plain(0, 0, 0)), white = histogramOf(plain(255, 255, 255));
  for (std::size_t c = 0; c < kPictureChannels; ++c) {
    EXPECT_EQ(chiSquare(black, black, c), 0);
    EXPECT_EQ(earthMovers(black, black, c), 0);
    if (kPictureChannelNames[c] == "hue") continue;
    EXPECT_NEAR(chiSquare(black, white, c), 1, 1e-12);
    EXPECT_NEAR(earthMovers(black, white, c), 1, 1e-12);
  }
  EXPECT_EQ(earthMovers(black, white, 1), 0) << "neither has a hue";
}

TEST(PictureHistogram, earthMoversTellsHowFarAndChiSquareOnlyThatItIsSomewhereElse) {
  // A tenth brighter is a tenth of the distance, to a bin of 64; for chi-square all that differs is as far.
  const PictureHistogram dark = histogramOf(plain(60, 60, 60)), near = histogramOf(plain(86, 86, 86)),
                         far = histogramOf(plain(188, 188, 188));
  EXPECT_NEAR(earthMovers(dark, near, 0), 0.1, 1.0 / 64);
  EXPECT_NEAR(earthMovers(dark, far, 0), 0.5, 1.0 / 64);
  EXPECT_NEAR(chiSquare(dark, near, 0), 1, 1e-12);
  EXPECT_NEAR(chiSquare(dark, far, 0), 1, 1e-12);
}

TEST(PictureHistogram, hueIsACircle) {
  // From 355 to 5 degrees are 10, and nothing is farther than half of the circle.
  const PictureHistogram before = histogramOf(plain(255, 0, 21)), after = histogramOf(plain(255, 21, 0)),
                         cyan = histogramOf(plain(0, 255, 255)), grey = histogramOf(plain(90, 90, 90));
  EXPECT_NEAR(earthMovers(before, after, 1), 10.0 / 360, 1.5 / 64);
  EXPECT_NEAR(earthMovers(before, cyan, 1), 0.5, 1.5 / 64);
  EXPECT_EQ(earthMovers(before, after, 1), earthMovers(after, before, 1));
  EXPECT_EQ(earthMovers(before, grey, 1), 0.5);
}

TEST(PictureHistogram, whatIsMaskedOrTransparentDoesNotCount) {
  core::Image picture = plain(200, 200, 200), mask = plain(0, 0, 0);
  for (int x = 0; x < 8; ++x) {
    for (int c = 0; c < 3; ++c) picture.pixel(x, 3)[c] = 10;
    for (int y = 0; y < 3; ++y) mask.pixel(x, y)[0] = 255;
  }
  EXPECT_EQ(histogramOf(picture, &mask).pixels, 24u);
  EXPECT_EQ(earthMovers(histogramOf(picture, &mask), histogramOf(plain(200, 200, 200)), 0), 0);
  EXPECT_GT(earthMovers(histogramOf(picture), histogramOf(plain(200, 200, 200)), 0), 0.1);
  const core::Image none = plain(0, 0, 0);
  EXPECT_THROW(histogramOf(picture, &none), core::RangeError);
  for (std::size_t i = 3; i < picture.rgba.size(); i += 4) picture.rgba[i] = 0;
  EXPECT_THROW(histogramOf(picture), core::RangeError);
}

}  // namespace
}  // namespace skydrop::accuracy
