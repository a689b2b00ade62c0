// Which patches of the mesh are drawn, given the chunks at hand.
#pragma once

#include <unordered_map>
#include <vector>

#include "skydrop/terrain/terrain_frame.h"
#include "skydrop/terrain/view_volume.h"
#include "terrain/chunk_selection.h"
#include "terrain/patch_bounds.h"

namespace skydrop::terrain {

struct UsableChunk {
  ArrayLayer layer = 0;
  const PatchBounds* bounds = nullptr;  // lives at least as long as the call
};

// Chunks that may be drawn from; with each also its ancestors are there.
using UsableChunks = std::unordered_map<ChunkKey, UsableChunk, ChunkKeyHash>;

struct PatchSelection {
  std::vector<PatchDraw> patches;  // the nearest first
  std::size_t coarsened = 0;       // patches drawn coarser than the view asks for because a chunk is missing
};

// Patches wholly below `floorM` are left out.
PatchSelection selectPatches(const ViewVolume& view, const LodDistances& lod, double farDistanceM,
                             double floorM, glm::dvec2 base, const UsableChunks& chunks,
                             const ChunkBounds& bounds);

}  // namespace skydrop::terrain
