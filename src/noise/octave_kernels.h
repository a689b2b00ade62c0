// The loops over one row of texels of an octave, compiled once for each instruction set
// (octave_kernels_*.cpp). Every set gives the bits of shaders/shared/gradient_noise.glsl: its scalar
// functions, in its order, without contraction.
//
// Why it is fast: over a row of the lattice the noise is, at each texel's x, a value and a slope by y. Those
// two rows are made once for all the rows of texels between two rows of the lattice, of nodes that are hashed
// once a lattice row. A row of texels is then two such rows and the fade of its y: five operations a texel,
// all of them contiguous.
#pragma once

#include <cstdint>

#include "skydrop/core/instruction_set.h"

namespace skydrop::noise {

using core::InstructionSet;

// How the texels of a row lie among the columns of an octave's lattice. Arrays of `width`, but for the
// columns.
struct RowInCells {
  int width = 0;
  int nodes = 0;                           // columns that the row needs
  const std::uint32_t* columns = nullptr;  // of `nodes`: their coordinates times kColumnStride
  // Of each texel: its two columns, as indices. Null where each texel has two columns of its own: first the
  // western ones of all texels, then the eastern ones.
  const std::uint32_t *west = nullptr, *east = nullptr;
  const float *inside = nullptr, *fade = nullptr;  // x in cells, from the western column; its fade
};

// A node's gradient along x and y, and its value at its own x and y; null in a plane, where that is 0.
struct NodeRow {
  float *x = nullptr, *y = nullptr, *own = nullptr;
};

// Texel by texel, along a row of the lattice.
struct LatticeRow {
  float *value = nullptr, *slope = nullptr;
};

struct OctaveKernels {
  // The nodes of a row of a plane's lattice. `row` is its coordinate times kRowStride, and the octave's salt.
  void (*planeNodes)(const RowInCells& texels, std::uint32_t row, const NodeRow& nodes);
  // Of a lattice in space, between the layers of the lattice below and above, w in cells from the one below.
  void (*spaceNodes)(const RowInCells& texels, std::uint32_t rowBelow, std::uint32_t rowAbove, float w,
                     const NodeRow& nodes);
  // `expanded` is room for 6 times `width` floats.
  void (*alongRow)(const RowInCells& texels, const NodeRow& nodes, float* expanded, const LatticeRow& row);
  // sum += weight * noise, at v in cells from the first row.
  void (*addRow)(int width, const LatticeRow& row, const LatticeRow& nextRow, float v, float weight,
                 float* sum);
  // Sums of octaves to values in [0, 1].
  void (*finish)(int width, float* sum);
};

// Null where this processor, or the build, lacks the set; never for the baseline.
const OctaveKernels* octaveKernels(InstructionSet set);

// Those of the widest set.
const OctaveKernels& bestOctaveKernels();

}  // namespace skydrop::noise
