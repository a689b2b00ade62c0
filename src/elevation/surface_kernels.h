// The loops over one row of a chunk's samples on elevation data, compiled once for each instruction set
// (surface_kernels_*.cpp). Every set gives the same bits, and a sample's arithmetic depends on its place in
// the world alone, never on the chunk or level that asks: so chunks and levels meet without a seam.
//
// Why a row is cheap: the chart is one polynomial of x along 4 km of it; of the bicubic surface the two axes
// separate, so that a sample takes four vectors of four cells; and weights, sums and codes have no branch.
#pragma once

#include <cstdint>

#include "skydrop/core/instruction_set.h"

namespace skydrop::elevation {

inline constexpr int kRowSize = 256;  // terrain::kChunkSamples and the normals on both sides, rounded up

// Pages of cells are squares with a rim, so that each bicubic patch that begins in one lies in it.
inline constexpr int kPageCells = 128;
inline constexpr int kPageSide = kPageCells + 3;  // one cell before, two after

// A row of the chart between two nodes as polynomials of t in [0, 1]: [power][column, row].
struct ChartPiece {
  double place[4][2];              // columns and rows of the lattice
  double east[2][2], south[2][2];  // what they change a metre
};

// One row of one mosaic, sample by sample.
struct SurfaceRow {
  alignas(64) double column[kRowSize], row[kRowSize];  // places on the lattice
  alignas(64) std::int32_t cellColumn[kRowSize], cellRow[kRowSize];
  alignas(64) float across[kRowSize], down[kRowSize];  // within the cell, [0, 1)
  // What places change a metre east and south.
  alignas(64) float eastColumn[kRowSize], eastRow[kRowSize], southColumn[kRowSize], southRow[kRowSize];
  // 1 - weight, and what it changes a cell.
  alignas(64) float rest[kRowSize], restColumn[kRowSize], restRow[kRowSize];
  // Of each sample the north-western of its 4 x 4 cells, in rows of kPageSide.
  const float* cells[kRowSize];
  alignas(64) float height[kRowSize], heightEast[kRowSize], heightSouth[kRowSize];  // metres, and a metre
};

// A row of the land put together of mosaics, and how much of it is still missing (`rest`, from 1 to 0).
struct LandRow {
  alignas(64) float height[kRowSize], east[kRowSize], south[kRowSize];
  alignas(64) float rest[kRowSize], restEast[kRowSize], restSouth[kRowSize];
};

// A rectangle of cells, half a cell around the centres of the outermost included; and over which distance
// beyond it the data fade.
struct FadingBlock {
  double left, top, right, bottom;  // lattice
  float cellEastM, cellSouthM;      // metres a cell
  float fadeM;
};

// Of the land that chunks of terrain::ChunkData hold.
struct ChunkCoding {
  float lowest, step;  // metres, metres a code
};

struct SurfaceKernels {
  // Samples from .. past - 1: places, cells and what places change a metre; sample s lies at t = first + s *
  // step.
  void (*places)(const ChartPiece& piece, double first, double step, int from, int past, SurfaceRow& row);
  // The weights beyond one more block; before the first of them `rest` is 1 and its changes are 0.
  void (*fade)(const FadingBlock& block, int from, int past, SurfaceRow& row);
  // Heights and their slopes, of `cells`.
  void (*surface)(int from, int past, SurfaceRow& row);
  // Adds the row by its weights; before the first mosaic `rest` is 1, all others are 0.
  void (*add)(int count, const SurfaceRow& row, LandRow& land);
  // Adds for the rest the land around, `raised` metres above what its codes say.
  void (*addAround)(int count, const ChunkCoding& coding, float raised, const std::uint16_t* heights,
                    const std::uint16_t* normals, LandRow& land);
  // HeightRange::encode and encodeNormal (terrain/chunk_data.h) in float.
  void (*finish)(int count, const ChunkCoding& coding, const LandRow& land, std::uint16_t* heights,
                 std::uint16_t* normals);
};

// Null where this processor, or the build, lacks the set; never for the baseline.
const SurfaceKernels* surfaceKernels(core::InstructionSet set);

// Those of the widest set.
const SurfaceKernels& bestSurfaceKernels();

}  // namespace skydrop::elevation
