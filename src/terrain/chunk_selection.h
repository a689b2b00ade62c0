// Which chunks a view needs, before any of them exists.
#pragma once

#include <functional>
#include <vector>

#include "skydrop/terrain/chunk_grid.h"
#include "skydrop/terrain/lod.h"
#include "skydrop/terrain/view_volume.h"

namespace skydrop::terrain {

struct WantedChunk {
  ChunkKey key;
  bool finest = false;  // in view, and none of its children is wanted
  bool inView = true;
};

// Conservative height bounds of a chunk's rectangle at every level of detail.
using ChunkBounds = std::function<HeightBounds(const ChunkKey&)>;

// The chunks that may be seen, from those of kMaxChunkLevel down to the finest that the distance asks for,
// with all their ancestors; and last those of kMaxChunkLevel that are out of view, so that there is land
// wherever the eye turns next. The most urgent first: the ones under the eye from fine to coarse, then by
// distance in units of their own size (so a parent stands before its children, and cutting the list short
// leaves coarser land, not holes).
std::vector<WantedChunk> selectChunks(const ViewVolume& view, const LodDistances& lod, double farDistanceM,
                                      const ChunkBounds& bounds);

}  // namespace skydrop::terrain
