// What EndlessTerrain tells the renderer to do in one frame: plain values, no GL.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <vector>

#include "skydrop/terrain/chunk_data.h"
#include "skydrop/terrain/lod.h"

namespace skydrop::terrain {

// One of a fixed number of places on the GPU that hold a chunk each.
using ArrayLayer = std::int32_t;

// Chunk data to be written to a layer before this frame is drawn. Whatever the layer held is void.
struct ChunkUpload {
  ArrayLayer layer = 0;
  std::shared_ptr<const ChunkData> data;
};

// A chunk that this frame may read from its layer.
struct ResidentChunk {
  ChunkKey key;
  ArrayLayer layer = 0;
};

// Edges of a patch. West is towards -x, north towards -z.
enum class PatchEdge { west, east, north, south };

// 15 x 15 cells of 4 m * 2^level.
struct PatchDraw {
  std::int32_t level = 0;     // 0 .. kTopPatchLevel - 1
  std::int32_t x = 0, z = 0;  // north-west corner: metres from TerrainFrame::base, a multiple of the cell
  ArrayLayer layer = 0;       // of the chunk that has the heights
  std::int32_t chunkLevel = 0;
  std::int32_t sampleX = 0, sampleZ = 0;  // of the corner in that chunk
  // By how many levels the neighbour behind each edge (PatchEdge) is coarser, 0 .. 4. The vertices on that
  // edge that the neighbour does not have are moved onto one that it has.
  std::array<std::uint8_t, 4> coarser{};
  double distanceM = 0;  // from the eye to the nearest point of the patch's box
};

inline constexpr int kTrianglesPerPatch = 2 * kPatchCells * kPatchCells;

struct TerrainFrame {
  // World position (x, z) from which the patches count: a chunk corner near the eye, so that the differences
  // are small whole numbers, exact in float, wherever in the world the eye is.
  glm::dvec2 base{0.0};
  HeightRange heightRange;  // of the heights in the layers: ChunkData::heightRange, the same for all
  LodDistances lod;
  double farDistanceM = 0;
  double seaFloorDepthM = 0;
  int layerCount = 0;  // a layer is less than this; when it changes, what the layers held is void
  std::vector<ChunkUpload> uploads;
  std::vector<ResidentChunk> chunks;  // each with all its ancestors
  std::vector<PatchDraw> patches;     // the nearest first
};

}  // namespace skydrop::terrain
