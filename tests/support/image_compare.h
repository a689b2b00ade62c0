// Pictures against references. Differences are in steps of 8 bits (1 = 1/255), over red, green and blue.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string_view>

#include "skydrop/core/image.h"

namespace skydrop::test {

struct ImageDifference {
  bool sameSize = false;
  int largest = 0;
  double mean = 0;
  double shareAbove2 = 0;  // of the pixels that differ by more than 2/255 in some channel
};

struct ImageLimits {
  int largest = 0;
  double mean = 0;
};

ImageDifference compareImages(const core::Image& a, const core::Image& b);
bool within(const ImageDifference& difference, const ImageLimits& limits);

// The pictures that show that the limits are not too wide: a comparer that accepts them sees nothing.
core::Image shiftedByOnePixel(const core::Image& image);
core::Image brightened(const core::Image& image, double factor);  // of the 8-bit values, clipped

// Where failing comparisons leave their pictures: <build folder>/artifacts.
std::filesystem::path artifactFolder();
void writeArtifact(std::string_view name, const core::Image& image);  // name without .png

// Compares with the PNG at `reference`. A failure writes <name>.actual.png, .reference.png and
// .difference.png (ten times the difference) to the artifact folder. With SKYDROP_UPDATE_GOLDENS=1 in the
// environment the reference is written instead.
::testing::AssertionResult matchesReference(const core::Image& actual, const std::filesystem::path& reference,
                                            const ImageLimits& limits);
// The same for two pictures at hand.
::testing::AssertionResult imagesMatch(const core::Image& actual, const core::Image& expected,
                                       const ImageLimits& limits, std::string_view name);

}  // namespace skydrop::test
