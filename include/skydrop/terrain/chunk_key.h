// The grid of chunks and the name of one chunk.
//
// The chunk (x, z) of a level covers [x, x + 1) * m by [z, z + 1) * m metres with m = chunkMetres(level): its
// first sample stands on the corner (x * m, z * m), its last on the corner of its neighbour, so neighbours
// share their border samples. Level 0 is full detail (4 m cells, 960 m); each level doubles both. Every
// corner and every sample position is an integer number of metres: exact in double up to kWorldLimitMetres.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>

#include "skydrop/core/hash.h"
#include "skydrop/core/shared.h"

namespace skydrop::terrain {

inline constexpr int kChunkCells = core::shared::f64::kChunkCells;     // along a side: 240
inline constexpr int kChunkSamples = kChunkCells + 1;                  // along a side
inline constexpr double kCellMetres = core::shared::f64::kCellMetres;  // sample distance at level 0: 4 m
inline constexpr double kChunkMetres = kCellMetres * kChunkCells;
// The coarsest level: 61 km, cells of 256 m, those of the finest gullies (land_gully.h).
inline constexpr std::int32_t kMaxChunkLevel = core::shared::f64::kMaxChunkLevel;
inline constexpr double kWorldLimitMetres = 0x1p50;  // 1.1e15 m: beyond it, doubles are 0.25 m apart

// A chunk's mesh at LOD i uses every kLodSkips[i]-th sample. Each skip divides the chunk and the next skip,
// so that the vertices of a level are among those of the one before it and levels can morph into each other.
// The chain goes on in the chunks of the next level: skip 2 there is skip 4 here. This needs what chunk
// makers promise: at a position that two levels share, both store the same height code.
inline constexpr std::array<int, 5> kLodSkips{1, 2, 4, 8, 16};
inline constexpr int kLodCount = static_cast<int>(kLodSkips.size());
static_assert(
    [] {
      for (std::size_t i = 0; i < kLodSkips.size(); ++i) {
        if (kChunkCells % kLodSkips[i] != 0 || (i > 0 && kLodSkips[i] % kLodSkips[i - 1] != 0)) return false;
      }
      return true;
    }(),
    "every skip divides the chunk and the next skip (hard case T08)");

struct ChunkKey {
  std::int64_t x = 0, z = 0;
  std::int32_t level = 0;  // 0 .. kMaxChunkLevel

  friend constexpr bool operator==(const ChunkKey&, const ChunkKey&) = default;
};

constexpr double cellMetres(std::int32_t level) {
  return kCellMetres * static_cast<double>(std::int64_t{1} << level);
}
constexpr double chunkMetres(std::int32_t level) { return cellMetres(level) * kChunkCells; }

// World position of the chunk's first sample, metres.
inline glm::dvec2 chunkOrigin(const ChunkKey& key) {
  return glm::dvec2(static_cast<double>(key.x), static_cast<double>(key.z)) * chunkMetres(key.level);
}

// 64 bits that differ for neighbouring keys, near the origin and far out (hard case T21).
constexpr std::uint64_t hashOf(const ChunkKey& key) {
  const std::uint64_t level = core::mix64(static_cast<std::uint64_t>(key.level));
  return core::hashCombine(core::hashCombine(level, static_cast<std::uint64_t>(key.x)),
                           static_cast<std::uint64_t>(key.z));
}

struct ChunkKeyHash {
  std::size_t operator()(const ChunkKey& key) const noexcept { return hashOf(key); }
};

}  // namespace skydrop::terrain
