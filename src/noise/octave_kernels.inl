// The body of octave_kernels_*.cpp, each of which defines SKYDROP_OCTAVE_KERNELS (the name of its table)
// first. Nothing here may call a function that is not forced inline (core/force_inline.h); so the shared
// files of scalars are compiled into this file's own namespace.

#include <cstdint>

#include "noise/octave_kernels.h"
#include "skydrop/core/force_inline.h"

namespace skydrop::noise {
namespace {

using Real = float;
using Uint = std::uint32_t;

#define FN SKYDROP_INLINE
#define CONST constexpr
// clang-format off
#include "shared/lattice.glsl"
#include "shared/lattice_gradients.glsl"
// clang-format on
#undef FN
#undef CONST

void planeNodes(const RowInCells& texels, std::uint32_t row, const NodeRow& nodes) {
  const std::uint32_t* columns = texels.columns;
  float* __restrict x = nodes.x;
  float* __restrict y = nodes.y;
  const int count = texels.nodes;
  for (int n = 0; n < count; ++n) {
    const std::uint32_t bits = latticeBits(columns[n], row);
    x[n] = planeGradientX(bits);
    y[n] = planeGradientY(bits);
  }
}

void spaceNodes(const RowInCells& texels, std::uint32_t rowBelow, std::uint32_t rowAbove, float w,
                const NodeRow& nodes) {
  const std::uint32_t* columns = texels.columns;
  float* __restrict x = nodes.x;
  float* __restrict y = nodes.y;
  float* __restrict own = nodes.own;
  const float fadeW = smoothStep5(w), fromAbove = w - 1.0f;
  const int count = texels.nodes;
  for (int n = 0; n < count; ++n) {
    const std::uint32_t below = latticeBits(columns[n], rowBelow), above = latticeBits(columns[n], rowAbove);
    x[n] = blend(spaceGradientX(below), spaceGradientX(above), fadeW);
    y[n] = blend(spaceGradientY(below), spaceGradientY(above), fadeW);
    own[n] = blend(spaceGradientZ(below) * w, spaceGradientZ(above) * fromAbove, fadeW);
  }
}

// Looked up once a row of the lattice, one by one.
void expand(const RowInCells& texels, const float* nodes, float* __restrict west, float* __restrict east) {
  for (int s = 0; s < texels.width; ++s) {
    west[s] = nodes[texels.west[s]];
    east[s] = nodes[texels.east[s]];
  }
}

// In a plane `own` is 0 and left out: 0 added changes no value, at most the sign of a zero.
template <bool kInSpace>
SKYDROP_INLINE void blendNodes(const RowInCells& texels, const NodeRow& westNodes, const NodeRow& eastNodes,
                               const LatticeRow& row) {
  const float* __restrict westX = westNodes.x;
  const float* __restrict westY = westNodes.y;
  const float* __restrict westOwn = westNodes.own;
  const float* __restrict eastX = eastNodes.x;
  const float* __restrict eastY = eastNodes.y;
  const float* __restrict eastOwn = eastNodes.own;
  const float* __restrict inside = texels.inside;
  const float* __restrict fade = texels.fade;
  float* __restrict value = row.value;
  float* __restrict slope = row.slope;
  const int width = texels.width;
#pragma GCC ivdep
  for (int s = 0; s < width; ++s) {
    float west = westX[s] * inside[s], east = eastX[s] * (inside[s] - 1.0f);
    if (kInSpace) west += westOwn[s], east += eastOwn[s];
    value[s] = blend(west, east, fade[s]);
    slope[s] = blend(westY[s], eastY[s], fade[s]);
  }
}

void alongRow(const RowInCells& texels, const NodeRow& nodes, float* expanded, const LatticeRow& row) {
  const bool inSpace = nodes.own != nullptr;
  const int width = texels.width;
  NodeRow west = nodes;
  NodeRow east{nodes.x + width, nodes.y + width, inSpace ? nodes.own + width : nullptr};
  if (texels.west != nullptr) {
    west = {expanded, expanded + 2 * width, expanded + 4 * width};
    east = {expanded + width, expanded + 3 * width, expanded + 5 * width};
    expand(texels, nodes.x, west.x, east.x);
    expand(texels, nodes.y, west.y, east.y);
    if (inSpace) expand(texels, nodes.own, west.own, east.own);
  }
  if (inSpace)
    blendNodes<true>(texels, west, east, row);
  else
    blendNodes<false>(texels, west, east, row);
}

void addRow(int width, const LatticeRow& row, const LatticeRow& nextRow, float v, float weight, float* sum) {
  const float* __restrict value = row.value;
  const float* __restrict slope = row.slope;
  const float* __restrict nextValue = nextRow.value;
  const float* __restrict nextSlope = nextRow.slope;
  float* __restrict out = sum;
  const float fadeV = smoothStep5(v), back = v - 1.0f;
  for (int s = 0; s < width; ++s) {
    out[s] += weight * blend(value[s] + v * slope[s], nextValue[s] + back * nextSlope[s], fadeV);
  }
}

void finish(int width, float* sum) {
  for (int s = 0; s < width; ++s) {
    const float value = 0.5f + 0.5f * sum[s];
    const float above = value > 0.0f ? value : 0.0f;
    sum[s] = above < 1.0f ? above : 1.0f;
  }
}

}  // namespace

extern const OctaveKernels SKYDROP_OCTAVE_KERNELS;
const OctaveKernels SKYDROP_OCTAVE_KERNELS{planeNodes, spaceNodes, alongRow, addRow, finish};

}  // namespace skydrop::noise
