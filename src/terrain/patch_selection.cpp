#include "terrain/patch_selection.h"

#include <algorithm>
#include <unordered_set>

namespace skydrop::terrain {
namespace {

// A patch by its place in the grid of its level: the same layout as a chunk's key, with cells of 60 m *
// 2^level.
using PatchKey = ChunkKey;

double patchMetres(std::int32_t level) { return kPatchCells * cellMetres(level); }

class Selector {
 public:
  Selector(const ViewVolume& view, const LodDistances& lod, double farDistance, double floor, glm::dvec2 base,
           const UsableChunks& chunks, const ChunkBounds& bounds)
      : view_(view),
        lod_(lod),
        farDistance_(farDistance),
        floor_(floor),
        base_(base),
        chunks_(chunks),
        bounds_(bounds) {}

  PatchSelection run() {
    // A patch of the top level covers a chunk of the top level.
    for (const auto& [key, chunk] : chunks_) {
      if (key.level == kTopLevel) visit({key.x, key.z, kTopPatchLevel});
    }
    for (PatchDraw& draw : selection_.patches) findCoarserNeighbours(draw);
    std::sort(selection_.patches.begin(), selection_.patches.end(),
              [](const PatchDraw& a, const PatchDraw& b) {
                if (a.distanceM != b.distanceM) return a.distanceM < b.distanceM;
                return a.z != b.z ? a.z < b.z : a.x < b.x;
              });
    return std::move(selection_);
  }

 private:
  // The chunk from which a patch takes its heights.
  static ChunkKey chunkOf(const PatchKey& patch) {
    const std::int32_t level = std::min(patch.level, kTopLevel);
    const int shift = kLodCount - 1 - (patch.level - level);
    return {patch.x >> shift, patch.z >> shift, level};
  }

  void visit(const PatchKey& patch) {
    const ChunkKey chunkKey = chunkOf(patch);
    const UsableChunk& chunk = chunks_.at(chunkKey);
    const glm::dvec2 origin = glm::dvec2(patch.x, patch.z) * patchMetres(patch.level);
    const glm::dvec2 end = origin + patchMetres(patch.level);
    // Finer levels may reach higher than the samples of this one: only bounds that hold for all of them may
    // cull here. They are known for whole chunks; smaller patches are few and are culled one by one below.
    if (patch.level >= kLodCount - 1) {
      const Box box = boxOf(origin, end, bounds_({patch.x, patch.z, patch.level - kLodCount + 1}));
      if (nearestGroundDistance(view_, box) > farDistance_ || !mayBeVisible(view_, box)) return;
    }
    const int step = patch.level - chunkKey.level;
    const std::int64_t mask = (kPatchesPerChunk >> step) - 1;
    const Box box =
        boxOf(origin, end,
              chunk.bounds->at(step, static_cast<int>(patch.x & mask), static_cast<int>(patch.z & mask)));
    const double distance = nearestDistance(view_, box);
    if (patch.level > 0 && lod_.lambda(distance) < patch.level) {
      const PatchKey child = childOf(patch, 0);  // the other three lie in the same chunk
      if (chunks_.contains(chunkOf(child))) {
        for (int quadrant = 0; quadrant < 4; ++quadrant) visit(childOf(patch, quadrant));
        return;
      }
      ++selection_.coarsened;
    }
    leaves_.insert(patch);
    if (box.hi.y < floor_ || !mayBeVisible(view_, box)) return;
    PatchDraw draw;
    draw.level = patch.level;
    draw.x = static_cast<std::int32_t>(origin.x - base_.x);
    draw.z = static_cast<std::int32_t>(origin.y - base_.y);
    draw.slot = chunk.slot;
    draw.chunkLevel = chunkKey.level;
    draw.sampleX = static_cast<std::int32_t>(patch.x & mask) * (kPatchCells << step);
    draw.sampleZ = static_cast<std::int32_t>(patch.z & mask) * (kPatchCells << step);
    draw.distanceM = distance;
    selection_.patches.push_back(draw);
    keys_.push_back(patch);
  }

  void findCoarserNeighbours(PatchDraw& draw) {
    const PatchKey& key = keys_[static_cast<std::size_t>(&draw - selection_.patches.data())];
    constexpr std::array<std::array<int, 2>, 4> kSteps{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};  // as PatchEdge
    for (std::size_t edge = 0; edge < kSteps.size(); ++edge) {
      PatchKey neighbour{key.x + kSteps[edge][0], key.z + kSteps[edge][1], key.level};
      for (int up = 0; up < kLodCount; ++up, neighbour = parentOf(neighbour)) {
        if (!leaves_.contains(neighbour)) continue;
        draw.coarser[edge] = static_cast<std::uint8_t>(up);
        break;
      }
    }
  }

  const ViewVolume& view_;
  const LodDistances& lod_;
  double farDistance_, floor_;
  glm::dvec2 base_;
  const UsableChunks& chunks_;
  const ChunkBounds& bounds_;
  PatchSelection selection_;
  std::vector<PatchKey> keys_;  // of selection_.patches
  std::unordered_set<PatchKey, ChunkKeyHash> leaves_;
};

}  // namespace

PatchSelection selectPatches(const ViewVolume& view, const LodDistances& lod, double farDistanceM,
                             double floorM, glm::dvec2 base, const UsableChunks& chunks,
                             const ChunkBounds& bounds) {
  return Selector(view, lod, farDistanceM, floorM, base, chunks, bounds).run();
}

}  // namespace skydrop::terrain
