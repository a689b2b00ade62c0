// The surface through heights on a lattice with the weights of Catmull and Rom (1974): through every height,
// C1. A float is enough for land (an ulp of 9000 m is 1 mm); double is what tests compare it with.
#pragma once

#include <array>
#include <cstddef>

#include "skydrop/core/force_inline.h"

namespace skydrop::elevation {

// Height, and slopes a cell, in the units of the heights.
template <class Real>
struct Patch {
  Real height, acrossSlope, downSlope;
};

template <class Real>
struct CubicWeights {
  Real value[4], slope[4];
};

// For four neighbours, t between the second (0) and the third (1). Forced inline: kernels of several
// instruction sets use it (surface_kernels.inl).
template <class Real>
SKYDROP_INLINE CubicWeights<Real> cubicWeights(Real t) {
  CubicWeights<Real> w;
  w.value[0] = t * (Real(-0.5) + t * (1 + t * Real(-0.5)));
  w.value[1] = 1 + t * (t * (Real(-2.5) + t * Real(1.5)));
  w.value[2] = t * (Real(0.5) + t * (2 + t * Real(-1.5)));
  w.value[3] = t * (t * (Real(-0.5) + t * Real(0.5)));
  w.slope[0] = Real(-0.5) + t * (2 + t * Real(-1.5));
  w.slope[1] = t * (-5 + t * Real(4.5));
  w.slope[2] = Real(0.5) + t * (4 + t * Real(-4.5));
  w.slope[3] = t * (-1 + t * Real(1.5));
  return w;
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
