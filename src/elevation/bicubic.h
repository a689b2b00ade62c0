// The surface through heights on a lattice with the weights of Catmull and Rom (1974): through every height,
// C1. A float is enough for land (an ulp of 9000 m is 1 mm); double is what tests compare it with.
#pragma once

#include <array>
#include <cstddef>

namespace skydrop::elevation {

// Height, and slopes a cell, in the units of the heights.
template <class Real>
struct Patch {
  Real height, acrossSlope, downSlope;
};

template <class Real>
struct CubicWeights {
  std::array<Real, 4> value, slope;
};

// For four neighbours, between the second (0) and the third (1).
template <class Real>
inline CubicWeights<Real> cubicWeights(Real t) {
  // Four at once, which compilers turn into one vector.
  constexpr std::array<Real, 4> kFlat{0, 1, 0, 0}, kLinear{Real(-0.5), 0, Real(0.5), 0},
      kSquare{1, Real(-2.5), 2, Real(-0.5)}, kCube{Real(-0.5), Real(1.5), Real(-1.5), Real(0.5)};
  CubicWeights<Real> weights;
  for (std::size_t i = 0; i < 4; ++i) {
    weights.value[i] = kFlat[i] + t * (kLinear[i] + t * (kSquare[i] + t * kCube[i]));
    weights.slope[i] = kLinear[i] + t * (2 * kSquare[i] + t * (3 * kCube[i]));
  }
  return weights;
}

// cells: 4 x 4 heights, `stride` apart from row to row; across and down in [0, 1] between the inner ones.
template <class Real, class Height>
inline Patch<Real> surfaceAt(const Height* cells, std::size_t stride, Real across, Real down) {
  const CubicWeights<Real> x = cubicWeights(across), y = cubicWeights(down);
  std::array<Real, 4> values{}, slopes{};
  for (std::size_t k = 0; k < 4; ++k) {
    const Height* row = cells + k * stride;
    for (std::size_t i = 0; i < 4; ++i) {
      values[i] += y.value[k] * static_cast<Real>(row[i]);
      slopes[i] += y.slope[k] * static_cast<Real>(row[i]);
    }
  }
  Patch<Real> out{0, 0, 0};
  for (std::size_t i = 0; i < 4; ++i) {
    out.height += x.value[i] * values[i];
    out.acrossSlope += x.slope[i] * values[i];
    out.downSlope += x.value[i] * slopes[i];
  }
  return out;
}

}  // namespace skydrop::elevation
