// How detail depends on distance, and on nothing else: not on time, not on what is loaded, not on the path
// that the eye took. docs/terrain-streaming.md tells the whole scheme.
//
// The vertices of level l stand on the world's grid of 4 m * 2^l. Each point of the land has a continuous
// level lambda(distance to the eye); the drawn height there lies between the meshes of the levels
// floor(lambda) and floor(lambda) + 1, mixed by the fraction (geomorphing: Hoppe, 1998; by distance: Strugar,
// "Continuous Distance-Dependent Level of Detail for Rendering Heightmaps", 2009). So two meshes that meet
// agree on their border wherever their vertices coincide, and a mesh can be exchanged for a coarser one
// without a pop.
//
// The mesh is drawn in patches of 15 x 15 cells (60 m at level 0). A patch of level l is used where lambda is
// at least l everywhere on it. It takes its heights from the chunk of level min(l, kMaxChunkLevel).
#pragma once

#include <array>
#include <cstdint>

#include "skydrop/terrain/chunk_key.h"
#include "skydrop/terrain/height_source.h"
#include "skydrop/terrain/terrain_streaming_settings.h"

namespace skydrop::terrain {

inline constexpr int kPatchCells = core::shared::f64::kPatchCells;  // along a side: 15
inline constexpr double kPatchMetres = kPatchCells * kCellMetres;
inline constexpr int kPatchesPerChunk = kChunkCells / kPatchCells;  // along a side, at the same level

// Coarsest level of patches, which goes beyond kMaxChunkLevel by the levels that the chunk's samples can
// carry.
inline constexpr int kTopPatchLevel = core::shared::f64::kTopPatchLevel;
static_assert(kTopPatchLevel == kMaxChunkLevel + kLodCount - 1);
static_assert(kChunkCells % kPatchCells == 0 && kPatchesPerChunk == kLodSkips.back(),
              "one patch covers a chunk at its coarsest skip (hard case T08)");

// Below this distance, times 2^level, a level is never used: patches must stay small against their distance,
// so that neighbours differ by few levels.
inline constexpr double kLeastReachM = 40;

// Vertical error of the mesh of each level against the land, metres: the value that 95 % of the land keeps
// below. Entry 0 is 0. Measured on the source at fixed places; the same source gives the same bits.
using ReliefErrors = std::array<double, kTopPatchLevel + 1>;
ReliefErrors measureRelief(const HeightSource& source);

// Distances in metres, rising with the level.
struct LodDistances {
  // lambda is 0 up to morph[0], l at morph[l], linear between, and below kTopPatchLevel however far
  // (shaders/shared/terrain_lod.glsl has it for the GPU).
  std::array<double, kTopPatchLevel + 1> morph{};

  // The samples of level l are fine enough from split[l] on: a chunk of level l is split where it comes
  // nearer. split[0] is 0.
  std::array<double, kMaxChunkLevel + 1> split{};

  double lambda(double distanceM) const;
};

LodDistances makeLodDistances(const ReliefErrors& relief, double pixelsPerRadian,
                              const TerrainStreamingSettings& settings);

}  // namespace skydrop::terrain
