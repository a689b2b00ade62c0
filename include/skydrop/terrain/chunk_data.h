// The samples of one chunk as the cache keeps them and the GPU reads them: 2 bytes a height, 2 bytes a
// normal.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <stop_token>
#include <vector>

#include "skydrop/terrain/chunk_key.h"
#include "skydrop/terrain/height_range.h"
#include "skydrop/terrain/height_source.h"

namespace skydrop::terrain {

// Normals are unit vectors with y > 0, kept in two bytes on the upper half of the octahedron, turned by 45
// degrees so that it fills the square (hemi-octahedral: Cigolle, Donow, Evangelakos, Mara, McGuire, Meyer: A
// Survey of Efficient Representations for Independent Unit Vectors, 2014). With s = |x| + y + |z|:
//     low byte  = 128 + round(127 * (x + z) / s)        high byte = 128 + round(127 * (x - z) / s)
// and back, e = (byte - 128) / 127 (from a UNORM texture: (value * 255 - 128) / 127):
//     x = (e0 + e1) / 2,   z = (e0 - e1) / 2,   y = 1 - |x| - |z|,   then normalise.
// The upright normal is exact; the largest error is 0.6 degrees, the mean 0.2 on land
// (docs/terrain-noise.md).
std::uint16_t encodeNormal(glm::dvec2 gradient);
glm::dvec3 decodeNormal(std::uint16_t code);

// Normals continue beyond the chunk's borders, so that what a pixel derives from normals at a distance comes
// from one chunk and is the same bits on both sides of a border. They reach kNormalReachM, or one sample
// where samples are wider.
inline constexpr double kNormalReachM = core::shared::f64::kNormalReachM;  // 24 m: of landCurvature (shaders)
constexpr int normalReach(std::int32_t level) {                            // samples
  int samples = 1;
  while (samples * cellMetres(level) < kNormalReachM) ++samples;
  return samples;
}

// Normals are stored in a square with room for that at every level; what lies beyond the reach is 0. Its side
// is a power of two: texture coordinates of samples are then exact in float, and both sides of a border
// filter with the same weights.
inline constexpr int kNormalSide = core::shared::f64::kNormalSide;      // 256
inline constexpr int kNormalMargin = core::shared::f64::kNormalMargin;  // 8 rows and columns before them
static_assert(normalReach(0) < kNormalMargin && kNormalMargin + kChunkSamples + normalReach(0) < kNormalSide);

// A value that may be handed between threads; about 247 kB.
struct ChunkData {
  ChunkKey key;
  HeightRange heightRange;             // of the source: what the codes of the heights mean
  std::vector<std::uint16_t> heights;  // kChunkSamples^2 codes, row-major: row = z (south), column = x (east)
  std::vector<std::uint16_t> normals;  // kNormalSide^2 codes, row-major (normalIndex)
  HeightBounds bounds;                 // exact for the stored (decoded) heights

  double height(std::size_t index) const { return heightRange.decode(heights[index]); }  // m; sampleIndex()
  bool empty() const { return heights.empty(); }
};

constexpr int sampleIndex(int column, int row) { return row * kChunkSamples + column; }
// Of the normal at a sample of the chunk, or beyond its borders: -reach .. kChunkCells + reach.
constexpr int normalIndex(int column, int row) {
  return (row + kNormalMargin) * kNormalSide + column + kNormalMargin;
}

// Bytes of a chunk's samples.
inline constexpr std::size_t kSampleBytes =
    sizeof(std::uint16_t) *
    (std::size_t{kChunkSamples} * kChunkSamples + std::size_t{kNormalSide} * kNormalSide);

// Makes a chunk over the source's stored range: the same bits on every machine and from any thread. The stop
// is honoured between rows; then the chunk comes back empty.
ChunkData makeChunk(const HeightSource& source, const ChunkKey& key, std::stop_token stop = {});

// The memory a chunk keeps, bytes: what a cache accounts for.
std::size_t byteSize(const ChunkData& chunk);

}  // namespace skydrop::terrain
