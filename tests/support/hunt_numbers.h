// Doubles for property tests of what is not in shaders/shared: edges of the format, neighbours of given
// thresholds, and any size. From a seed and a counter, so that a failure can be made again.
#pragma once

#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <vector>

#include "skydrop/core/hash.h"

namespace skydrop::test {

class HuntNumbers {
 public:
  explicit HuntNumbers(std::uint64_t seed) : random_{seed, 0} {}

  double unit() { return random_.nextUnit(); }
  std::uint64_t pick(std::uint64_t count) { return random_.next() % count; }

  // Of any sign and size from 1e-30 to 1e30, zeros of both signs, denormal numbers, and `near` with
  // neighbours.
  double finite(std::initializer_list<double> near = {}) {
    static constexpr std::array<double, 12> kEdges = {
        0,  -0.0, 5e-324, -5e-324, 2.2250738585072014e-308, -2.2250738585072014e-308, 1e-30, 1,
        -1, 1e30, -1e30,  0.5};
    const std::uint64_t way = pick(6);
    if (way == 0) return kEdges[pick(kEdges.size())];
    if (way <= 2 && near.size() > 0) {
      double value = *(near.begin() + static_cast<std::ptrdiff_t>(pick(near.size())));
      const auto steps = static_cast<int>(pick(7)) - 3;
      for (int i = 0; i < std::abs(steps); ++i)
        value = std::nextafter(value, steps < 0 ? -kEndless : kEndless);
      return value;
    }
    const double size = std::pow(10.0, way == 3 ? unit() * 60 - 30 : unit() * 10 - 3);
    return pick(2) == 0 ? size : -size;
  }
  // Those, infinities and NaN.
  double any(std::initializer_list<double> near = {}) {
    const std::uint64_t way = pick(12);
    if (way == 0) return std::numeric_limits<double>::quiet_NaN();
    if (way == 1) return pick(2) == 0 ? kEndless : -kEndless;
    return finite(near);
  }
  double within(double low, double high) {
    return std::fmin(std::fmax(pick(4) == 0 ? finite({low, high}) : low + (high - low) * unit(), low), high);
  }

 private:
  static constexpr double kEndless = std::numeric_limits<double>::infinity();
  core::RandomStream random_;
};

}  // namespace skydrop::test
