#include "support/image_compare.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "support/paths.h"

namespace skydrop::test {
namespace {

core::Image differenceImage(const core::Image& a, const core::Image& b) {
  core::Image image(a.width, a.height);
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      for (int c = 0; c < 3; ++c) {
        image.pixel(x, y)[c] =
            static_cast<std::uint8_t>(std::min(255, 10 * std::abs(a.pixel(x, y)[c] - b.pixel(x, y)[c])));
      }
      image.pixel(x, y)[3] = 255;
    }
  }
  return image;
}

}  // namespace

ImageDifference compareImages(const core::Image& a, const core::Image& b) {
  ImageDifference result;
  result.sameSize = a.width == b.width && a.height == b.height;
  if (!result.sameSize) return result;
  double sum = 0;
  int above = 0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      int largest = 0;
      for (int c = 0; c < 3; ++c) {
        const int difference = std::abs(a.pixel(x, y)[c] - b.pixel(x, y)[c]);
        largest = std::max(largest, difference);
        sum += difference;
      }
      result.largest = std::max(result.largest, largest);
      above += largest > 2;
    }
  }
  const double pixels = static_cast<double>(a.width) * a.height;
  result.mean = sum / (3 * pixels);
  result.shareAbove2 = above / pixels;
  return result;
}

bool within(const ImageDifference& difference, const ImageLimits& limits) {
  return difference.sameSize && difference.largest <= limits.largest && difference.mean <= limits.mean;
}

core::Image shiftedByOnePixel(const core::Image& image) {
  core::Image shifted(image.width, image.height);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      std::copy_n(image.pixel(std::max(x - 1, 0), y), 4, shifted.pixel(x, y));
    }
  }
  return shifted;
}

core::Image brightened(const core::Image& image, double factor) {
  core::Image bright = image;
  for (std::size_t i = 0; i < bright.rgba.size(); ++i) {
    if (i % 4 != 3)
      bright.rgba[i] = static_cast<std::uint8_t>(std::clamp(std::lround(bright.rgba[i] * factor), 0l, 255l));
  }
  return bright;
}

std::filesystem::path artifactFolder() { return std::filesystem::path(test::binaryDir()) / "artifacts"; }

void writeArtifact(std::string_view name, const core::Image& image) {
  std::filesystem::create_directories(artifactFolder());
  core::writePng(artifactFolder() / (std::string(name) + ".png"), image);
}

::testing::AssertionResult imagesMatch(const core::Image& actual, const core::Image& expected,
                                       const ImageLimits& limits, std::string_view name) {
  const ImageDifference difference = compareImages(actual, expected);
  if (within(difference, limits)) return ::testing::AssertionSuccess();
  const std::string stem(name);
  writeArtifact(stem + ".actual", actual);
  writeArtifact(stem + ".reference", expected);
  if (!difference.sameSize) {
    return ::testing::AssertionFailure() << stem << ": " << actual.width << "x" << actual.height
                                         << " instead of " << expected.width << "x" << expected.height;
  }
  writeArtifact(stem + ".difference", differenceImage(actual, expected));
  return ::testing::AssertionFailure() << stem << ": largest difference " << difference.largest << " (limit "
                                       << limits.largest << "), mean " << difference.mean << " (limit "
                                       << limits.mean << "); pictures in " << artifactFolder().string();
}

::testing::AssertionResult matchesReference(const core::Image& actual, const std::filesystem::path& reference,
                                            const ImageLimits& limits) {
  const char* bless = std::getenv("SKYDROP_UPDATE_GOLDENS");
  if (bless && std::string_view(bless) == "1") {
    std::filesystem::create_directories(reference.parent_path());
    core::writePng(reference, actual);
    return ::testing::AssertionSuccess();
  }
  if (!std::filesystem::exists(reference)) {
    writeArtifact(reference.stem().string() + ".actual", actual);
    return ::testing::AssertionFailure()
           << "no reference " << reference.string() << "; SKYDROP_UPDATE_GOLDENS=1 writes it";
  }
  return imagesMatch(actual, core::readPng(reference), limits, reference.stem().string());
}

}  // namespace skydrop::test
