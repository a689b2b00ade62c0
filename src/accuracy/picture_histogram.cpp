#include "skydrop/accuracy/picture_histogram.h"

#include <algorithm>
#include <cmath>

#include "skydrop/core/error.h"

namespace skydrop::accuracy {
namespace {

constexpr std::size_t kHue = 1;

std::size_t binOf(double value) {  // of [0, 1]
  return std::min(static_cast<std::size_t>(value * kHistogramBins), kHistogramBins - 1);
}

// Of HSV, [0, 1); of grey 0.
double hueOf(double r, double g, double b, double most, double chroma) {
  if (!(chroma > 0)) return 0;
  const double sixth = most == r ? (g - b) / chroma : most == g ? 2 + (b - r) / chroma : 4 + (r - g) / chroma;
  const double hue = sixth / 6;
  return hue < 0 ? hue + 1 : hue;
}

double sumOf(const std::array<double, kHistogramBins>& shares) {
  double sum = 0;
  for (const double share : shares) sum += share;
  return sum;
}

}  // namespace

PictureHistogram histogramOf(const core::Image& picture, const core::Image* mask) {
  PictureHistogram out;
  double colour = 0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const std::uint8_t* pixel = picture.pixel(x, y);
      if (pixel[3] < 128) continue;
      if (mask) {
        const auto at = [](int i, int of, int to) {
          return static_cast<int>(static_cast<std::int64_t>(i) * to / of);
        };
        if (mask->pixel(at(x, picture.width, mask->width), at(y, picture.height, mask->height))[0] < 128)
          continue;
      }
      ++out.pixels;
      const double r = pixel[0] / 255.0, g = pixel[1] / 255.0, b = pixel[2] / 255.0;
      const double most = std::max({r, g, b}), chroma = most - std::min({r, g, b});
      out.share[0][binOf(0.2126 * r + 0.7152 * g + 0.0722 * b)] += 1;
      out.share[kHue][binOf(hueOf(r, g, b, most, chroma))] += chroma;
      out.share[2][binOf(r)] += 1, out.share[3][binOf(g)] += 1, out.share[4][binOf(b)] += 1;
      colour += chroma;
    }
  }
  if (out.pixels == 0) throw core::RangeError("no pixel counts: all are masked or transparent");
  for (std::size_t c = 0; c < kPictureChannels; ++c) {
    const double all = c == kHue ? colour : static_cast<double>(out.pixels);
    for (double& share : out.share[c]) share = all > 0 ? share / all : 0;
  }
  return out;
}

double chiSquare(const PictureHistogram& a, const PictureHistogram& b, std::size_t channel) {
  double sum = 0;
  for (std::size_t i = 0; i < kHistogramBins; ++i) {
    const double p = a.share[channel][i], q = b.share[channel][i];
    if (p + q > 0) sum += (p - q) * (p - q) / (p + q);
  }
  return sum / 2;
}

double earthMovers(const PictureHistogram& a, const PictureHistogram& b, std::size_t channel) {
  const auto &p = a.share[channel], &q = b.share[channel];
  if (channel == kHue) {
    const bool hasA = sumOf(p) > 0, hasB = sumOf(q) > 0;
    if (!hasA || !hasB) return hasA == hasB ? 0 : 0.5;
  }
  std::array<double, kHistogramBins> ahead{};  // of the cumulative shares
  double difference = 0;
  for (std::size_t i = 0; i < kHistogramBins; ++i) ahead[i] = difference += p[i] - q[i];
  double middle = 0;
  if (channel == kHue) {
    std::array<double, kHistogramBins> sorted = ahead;
    std::ranges::nth_element(sorted, sorted.begin() + kHistogramBins / 2);
    middle = sorted[kHistogramBins / 2];
  }
  double moved = 0;
  for (const double value : ahead) moved += std::abs(value - middle);
  return moved / (channel == kHue ? kHistogramBins : kHistogramBins - 1);
}

}  // namespace skydrop::accuracy
