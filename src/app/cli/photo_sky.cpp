#include "app/cli/photo_sky.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace skydrop::app {
namespace {

constexpr int kMostSide = 320;  // of what is looked at: finer edges are texture

void paint(core::Image& mask, int x, int y, bool isSky) {
  std::uint8_t* pixel = mask.pixel(x, y);
  std::fill_n(pixel, 3, isSky ? std::uint8_t{255} : std::uint8_t{0});
  pixel[3] = 255;
}

struct Colour {
  std::array<double, 3> rgb{};
};

// Means over squares of `times` pixels.
struct Small {
  int width = 0, height = 0, times = 1;
  std::vector<Colour> pixels;

  const Colour& at(int x, int y) const {
    return pixels[static_cast<std::size_t>(std::clamp(y, 0, height - 1)) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(std::clamp(x, 0, width - 1))];
  }
  double grey(int x, int y) const {
    const auto& c = at(x, y).rgb;
    return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
  }
};

Small reduced(const core::Image& photo) {
  Small small;
  small.times = (std::max(photo.width, photo.height) + kMostSide - 1) / kMostSide;
  small.width = std::max(1, photo.width / small.times);
  small.height = std::max(1, photo.height / small.times);
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) {
      Colour mean;
      int count = 0;
      for (int v = y * small.times; v < std::min((y + 1) * small.times, photo.height); ++v) {
        for (int u = x * small.times; u < std::min((x + 1) * small.times, photo.width); ++u, ++count) {
          for (std::size_t c = 0; c < 3; ++c) mean.rgb[c] += photo.pixel(u, v)[c];
        }
      }
      for (double& c : mean.rgb) c /= count;
      small.pixels.push_back(mean);
    }
  }
  return small;
}

std::vector<double> gradients(const Small& small) {
  std::vector<double> out;
  out.reserve(small.pixels.size());
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) {
      const auto g = [&](int dx, int dy) { return small.grey(x + dx, y + dy); };
      const double gx = g(1, -1) + 2 * g(1, 0) + g(1, 1) - g(-1, -1) - 2 * g(-1, 0) - g(-1, 1);
      const double gy = g(-1, 1) + 2 * g(0, 1) + g(1, 1) - g(-1, -1) - 2 * g(0, -1) - g(1, -1);
      out.push_back(std::hypot(gx, gy));
    }
  }
  return out;
}

// Covariance of colours: determinant, and its largest eigenvalue by powers.
struct Spread {
  double count = 0;
  std::array<double, 3> sum{};
  std::array<std::array<double, 3>, 3> products{};

  void add(const Colour& colour) {
    ++count;
    for (std::size_t i = 0; i < 3; ++i) {
      sum[i] += colour.rgb[i];
      for (std::size_t k = 0; k < 3; ++k) products[i][k] += colour.rgb[i] * colour.rgb[k];
    }
  }
  // The determinant of a covariance whose smallest variances are those of rounding, and the eigenvalue.
  std::pair<double, double> measures() const {
    std::array<std::array<double, 3>, 3> m{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k)
        m[i][k] = products[i][k] / count - sum[i] / count * (sum[k] / count) + (i == k ? 1.0 / 12 : 0);
    }
    const double determinant = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                               m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                               m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    std::array<double, 3> v{0.57, 0.58, 0.59};
    double length = 0;
    for (int round = 0; round < 20; ++round) {
      std::array<double, 3> next{};
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k) next[i] += m[i][k] * v[k];
      length = std::sqrt(next[0] * next[0] + next[1] * next[1] + next[2] * next[2]);
      for (std::size_t i = 0; i < 3; ++i) v[i] = next[i] / length;
    }
    return {std::abs(determinant), length};
  }
};

}  // namespace

core::Image skyOfFrame(const render::View& view, std::span<const float> landDepth) {
  core::Image mask(view.width, view.height);
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      const int fromBelow = view.height - 1 - y;
      bool isSky = true;
      if (!landDepth.empty()) {
        const std::size_t i = static_cast<std::size_t>(fromBelow) * static_cast<std::size_t>(view.width) +
                              static_cast<std::size_t>(x);
        isSky = landDepth[i] <= 0 && render::rayDirection(view, {x + 0.5, fromBelow + 0.5}).y >= 0;
      }
      paint(mask, x, y, isSky);
    }
  }
  return mask;
}

core::Image skyOfPhoto(const core::Image& photo) {
  const Small small = reduced(photo);
  const std::vector<double> edge = gradients(small);
  constexpr double kLowest = 5, kHighest = 600, kSkyWeight = 2;
  constexpr int kSteps = 60;
  std::vector<int> best(static_cast<std::size_t>(small.width), small.height), border(best);
  double bestEnergy = -1;
  for (int step = 0; step < kSteps; ++step) {
    const double threshold = kLowest + (kHighest - kLowest) * step * step / ((kSteps - 1.0) * (kSteps - 1.0));
    Spread sky, ground;
    for (int x = 0; x < small.width; ++x) {
      int y = 0;
      while (y < small.height && edge[static_cast<std::size_t>(y) * static_cast<std::size_t>(small.width) +
                                      static_cast<std::size_t>(x)] <= threshold)
        ++y;
      border[static_cast<std::size_t>(x)] = y;
      for (int row = 0; row < small.height; ++row) (row < y ? sky : ground).add(small.at(x, row));
    }
    constexpr double kLeast = 4;  // pixels: less is no side
    if (sky.count < kLeast || ground.count < kLeast) continue;
    const auto [skyVolume, skyLength] = sky.measures();
    const auto [groundVolume, groundLength] = ground.measures();
    const double energy = 1 / (kSkyWeight * skyVolume + groundVolume + kSkyWeight * skyLength + groundLength);
    if (energy <= bestEnergy) continue;
    bestEnergy = energy;
    best = border;
  }
  core::Image mask(photo.width, photo.height);
  for (int y = 0; y < photo.height; ++y) {
    for (int x = 0; x < photo.width; ++x) {
      const int column = std::min(x / small.times, small.width - 1);
      paint(mask, x, y, y / small.times < best[static_cast<std::size_t>(column)]);
    }
  }
  return mask;
}

}  // namespace skydrop::app
