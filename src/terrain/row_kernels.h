// The loops over one row of a chunk's samples, compiled once for each instruction set (row_kernels_*.cpp).
// Every set gives the same bits: the sources are the same plain loops, without contraction or reordering, and
// a sample's arithmetic does not depend on where in its row it stands.
//
// The row is why no gather is needed: along a row, z is constant, so the two gradients of a lattice column
// fold into a value and a slope; between two columns the noise is then a polynomial of x alone.
#pragma once

#include <array>
#include <cstdint>

#include "skydrop/core/instruction_set.h"
#include "skydrop/terrain/chunk_key.h"
#include "terrain/land_gully.h"
#include "terrain/land_shape.h"

namespace skydrop::terrain {

// Rows are padded: in front and behind by what whole lattice cells of up to 16 samples stick out, and so that
// their length is a multiple of 8 floats.
inline constexpr int kRowPad = 16;
inline constexpr int kRowSize = 256;  // kChunkSamples and the normals on both sides of them, rounded up

struct alignas(64) PaddedRow {
  float storage[kRowPad + kRowSize + kRowPad + 8] = {};
  float* samples() { return storage + kRowPad; }
  const float* samples() const { return storage + kRowPad; }
};

// One value and its gradient along a row.
struct JetRow {
  PaddedRow v, x, z;
};

struct RowState {
  LandFields<JetRow> fields;
  LandState<JetRow> land;
};

// Gradients of lattice nodes along a lattice row.
struct NodeRow {
  std::array<float, kRowSize + 8> x{}, z{};
};

// How a row of samples lies in the cells of an octave. Sample s lies in cell c = (s + phase) / perCell at
// index k = (s + phase) % perCell in it; u[k], fade[k] and fadeSlope[k] are x in cells there, and its fade.
// Where cells are smaller than the samples' distance, each sample has a cell of its own: perCell is 1, c = s.
struct RowInCells {
  int perCell = 1;
  int phase = 0;
  int cells = 0;
  const float *u = nullptr, *fade = nullptr, *fadeSlope = nullptr;
  float w = 0, fadeZ = 0, fadeSlopeZ = 0;  // z in cells, and its fade
  float perMetre = 1;                      // 1 / cell
  bool carriesGradient = true;             // false: the gradient counts as 0 (docs/terrain-noise.md)
};

// One octave over one row of samples.
struct OctaveRow : RowInCells {
  // Nodes of cell c at index c: west and east, north and south of it.
  const float *northWestX = nullptr, *northWestZ = nullptr, *northEastX = nullptr, *northEastZ = nullptr;
  const float *southWestX = nullptr, *southWestZ = nullptr, *southEastX = nullptr, *southEastZ = nullptr;
  float amplitude = 1;  // of the octave; kNoiseScale included
};

// Nodes of gullies along a lattice row.
struct GullyNodeRow {
  std::array<float, kRowSize + 8> turnsX{}, turnsZ{}, phase{}, amplitude{};
};

// One octave of gullies over one row of samples. Node c and the next are west and east of cell c.
struct GullyRow : RowInCells {
  const GullyNodeRow *north = nullptr, *south = nullptr;
  int firstNode = 0;  // index of cell 0's western nodes in north and south
  float metres = 1;
};

struct RowKernels {
  // Gradients of `count` nodes first, first + stride, ... of a lattice row.
  void (*nodes)(std::uint64_t rowSeed, std::int64_t first, std::int64_t stride, int count, NodeRow& out);
  // The octave's noise, stored to `out` or added to it.
  void (*storeNoise)(const OctaveRow& octave, JetRow& out);
  void (*addNoise)(const OctaveRow& octave, JetRow& out);
  // The steps of LandShape: state.fields to state.land; gullies onto state.land.height; state.land to codes
  // of the heights and normals of the row's first `count` samples (chunk_data.h).
  void (*begin)(const LandShape<float>& shape, RowState& state);
  void (*gully)(const GullyRow& octave, RowState& state);
  void (*finish)(const LandShape<float>& shape, const RowState& state, int count, std::uint16_t* heights,
                 std::uint16_t* normals);
  // The nodes first, first + 1, ... of a row of gullies that stand on the samples of state.land.
  void (*gullyNodes)(std::uint64_t rowSeed, std::int64_t first, int count, const RowState& state,
                     GullyNodeRow& out);
};

using core::InstructionSet;
using core::kInstructionSets;

// Null where this processor, or the build, lacks the set; never for the baseline.
const RowKernels* rowKernels(InstructionSet set);

// Those of the widest set.
const RowKernels& bestRowKernels();

}  // namespace skydrop::terrain
