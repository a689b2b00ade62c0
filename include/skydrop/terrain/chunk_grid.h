// From positions to cells of the chunk grid, exactly: the index is the floor of the exact quotient, also on
// borders, a hair below them, and 1e12 m out, where float arithmetic picks the wrong chunk (hard case T04).
#pragma once

#include <cassert>
#include <cmath>
#include <cstdint>

#include "skydrop/terrain/chunk_key.h"

namespace skydrop::terrain {

// floor(metres / sizeMetres), exact for |metres| <= kWorldLimitMetres and sizes of 60 m * 2^k, k >= 0 (chunks
// and patches): index * size has at most 53 significant bits there, so the comparison below is exact.
inline std::int64_t gridIndex(double metres, double sizeMetres) {
  assert(std::abs(metres) <= kWorldLimitMetres);
  // The rounded quotient is off by less than one, so its floor is off by at most one.
  auto index = static_cast<std::int64_t>(std::floor(metres / sizeMetres));
  if (static_cast<double>(index) * sizeMetres > metres) --index;
  if (static_cast<double>(index + 1) * sizeMetres <= metres) ++index;
  return index;
}

// The chunk of this level that holds the position (x, z), metres.
inline ChunkKey chunkAt(glm::dvec2 xz, std::int32_t level = 0) {
  const double size = chunkMetres(level);
  return {gridIndex(xz.x, size), gridIndex(xz.y, size), level};
}

// Low 20 bits of a chunk's index, signed, as shaders count chunks: enough for their table and for the noise's
// lattice, which goes on across the origin and has its seams 5e8 m out.
constexpr int wrappedIndex(std::int64_t index) {
  return (static_cast<int>(index & 0xfffff) ^ 0x80000) - 0x80000;
}

// The chunk of the next coarser level that covers this one. The shift floors, also for negative indices.
constexpr ChunkKey parentOf(const ChunkKey& key) { return {key.x >> 1, key.z >> 1, key.level + 1}; }

// One of the four chunks of the next finer level: bit 0 of `quadrant` is east, bit 1 is south.
constexpr ChunkKey childOf(const ChunkKey& key, int quadrant) {
  return {2 * key.x + (quadrant & 1), 2 * key.z + (quadrant >> 1), key.level - 1};
}

}  // namespace skydrop::terrain
