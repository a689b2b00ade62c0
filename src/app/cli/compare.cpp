#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <numeric>

#include "app/cli/verbs.h"
#include "app/console/message.h"
#include "app/console/standard_output.h"
#include "skydrop/accuracy/flip.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/image.h"

namespace skydrop::app {
namespace {

struct Comparison {
  int largest = 0;                 // of all channels, in steps of 8 bits
  double mean = 0;                 // of all channels, in such steps
  std::size_t pixels = 0;          // that differ
  double flip = 0;                 // mean of flipErrors
  std::vector<double> flipErrors;  // of each pixel
  core::Image difference;          // magnitudes, stretched so that the largest is white
};

std::vector<double> seenValues(const core::Image& image) {
  std::vector<double> values;
  values.reserve(image.rgba.size() / 4 * 3);
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    if (i % 4 != 3) values.push_back(image.rgba[i] / 255.0);
  }
  return values;
}

Comparison compared(const core::Image& a, const core::Image& b) {
  Comparison result;
  result.difference = core::Image(a.width, a.height);
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    bool differs = false;
    for (std::size_t c = 0; c < 4; ++c) {
      const int difference = std::abs(int{a.rgba[i + c]} - int{b.rgba[i + c]});
      result.largest = std::max(result.largest, difference);
      sum += static_cast<std::uint64_t>(difference);
      differs = differs || difference > 0;
    }
    result.pixels += differs ? 1 : 0;
  }
  result.mean = static_cast<double>(sum) / static_cast<double>(a.rgba.size());
  const int stretch = std::max(result.largest, 1);
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    for (std::size_t c = 0; c < 3; ++c) {
      const int difference = std::abs(int{a.rgba[i + c]} - int{b.rgba[i + c]});
      result.difference.rgba[i + c] = static_cast<std::uint8_t>(difference * 255 / stretch);
    }
    result.difference.rgba[i + 3] = 255;
  }
  const std::vector<double> seenA = seenValues(a), seenB = seenValues(b);
  result.flipErrors = accuracy::flipMap({a.width, a.height, seenA}, {b.width, b.height, seenB});
  result.flip = std::accumulate(result.flipErrors.begin(), result.flipErrors.end(), 0.0) /
                static_cast<double>(result.flipErrors.size());
  return result;
}

std::string sizeText(const core::Image& image) {
  return std::to_string(image.width) + " x " + std::to_string(image.height);
}

// Empty: within the limits.
std::string excess(const PictureComparison& asked, const Comparison& found) {
  std::array<char, 96> text{};
  if (asked.most && found.largest > *asked.most) {
    std::snprintf(text.data(), text.size(), "the largest difference is %d, more than %d", found.largest,
                  *asked.most);
  } else if (asked.mean && found.mean > *asked.mean) {
    std::snprintf(text.data(), text.size(), "the mean difference is %.4g, more than %.4g", found.mean,
                  *asked.mean);
  } else if (asked.flip && found.flip > *asked.flip) {
    std::snprintf(text.data(), text.size(), "the mean FLIP is %.4g, more than %.4g", found.flip, *asked.flip);
  }
  return text.data();
}

}  // namespace

int compare(const CommandLine& line) {
  const PictureComparison& asked = line.comparison;
  const core::Image picture = core::readPng(asked.files[0]), reference = core::readPng(asked.files[1]);
  if (picture.width != reference.width || picture.height != reference.height)
    throw core::DataError(
        asked.files[0].string(), "",
        "is " + sizeText(picture) + ", not " + sizeText(reference) + " as " + asked.files[1].string());
  const Comparison found = compared(picture, reference);
  if (asked.folder) {
    core::makeFolder(*asked.folder);
    core::writePng(*asked.folder / "difference.png", found.difference);
    core::writePng(*asked.folder / "flip.png",
                   accuracy::heatMap(found.flipErrors, picture.width, picture.height));
  }
  const std::string reason = excess(asked, found);
  if (line.asJson) {
    const nlohmann::ordered_json report = {
        {"width", picture.width},          {"height", picture.height}, {"differingPixels", found.pixels},
        {"largest", found.largest},        {"mean", found.mean},       {"flip", found.flip},
        {"isWithinLimits", reason.empty()}};
    print("%s\n", report.dump(2).c_str());
  } else {
    print("%zu of %zu pixels differ, by %d of 255 at most and %.4g in the mean; mean FLIP %.4g\n",
          found.pixels, found.flipErrors.size(), found.largest, found.mean, found.flip);
  }
  if (reason.empty()) return 0;
  warn("compare: " + reason);
  return 1;
}

}  // namespace skydrop::app
