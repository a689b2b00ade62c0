#include "terrain/patch_selection.h"

#include <algorithm>
#include <array>
#include <optional>
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
      if (key.level == kMaxChunkLevel) visit({key.x, key.z, kTopPatchLevel});
    }
    splitBesideFine();
    mergeBesideCoarse();
    for (const Leaves& leaves : leaves_) {
      for (const PatchKey& patch : leaves) draw(patch);
    }
    std::sort(selection_.patches.begin(), selection_.patches.end(),
              [](const PatchDraw& a, const PatchDraw& b) {
                if (a.distanceM != b.distanceM) return a.distanceM < b.distanceM;
                return a.z != b.z ? a.z < b.z : a.x < b.x;
              });
    return std::move(selection_);
  }

 private:
  using Leaves = std::unordered_set<PatchKey, ChunkKeyHash>;

  // The chunk from which a patch takes its heights.
  static ChunkKey chunkOf(const PatchKey& patch) {
    const std::int32_t level = std::min(patch.level, kMaxChunkLevel);
    const int shift = kLodCount - 1 - (patch.level - level);
    return {patch.x >> shift, patch.z >> shift, level};
  }

  Leaves& leavesOf(const PatchKey& patch) { return leaves_[static_cast<std::size_t>(patch.level)]; }

  // A patch can be split if its children have a chunk: all four share one.
  bool canSplit(const PatchKey& patch) const {
    return patch.level > 0 && chunks_.contains(chunkOf(childOf(patch, 0)));
  }

  static glm::dvec2 originOf(const PatchKey& patch) {
    return glm::dvec2(patch.x, patch.z) * patchMetres(patch.level);
  }

  Box boxOfPatch(const PatchKey& patch) const {
    const ChunkKey chunk = chunkOf(patch);
    const int step = patch.level - chunk.level;
    const std::int64_t mask = (kPatchesPerChunk >> step) - 1;
    const glm::dvec2 origin = originOf(patch);
    return boxOf(origin, origin + patchMetres(patch.level),
                 chunks_.at(chunk).bounds->at(step, static_cast<int>(patch.x & mask),
                                              static_cast<int>(patch.z & mask)));
  }

  void visit(const PatchKey& patch) {
    // Finer levels may reach higher than the samples of this one: only bounds that hold for all of them may
    // cull here. They are known for whole chunks; smaller patches are few and are culled one by one when
    // drawn.
    if (patch.level >= kLodCount - 1) {
      const glm::dvec2 origin = originOf(patch);
      const Box box = boxOf(origin, origin + patchMetres(patch.level),
                            bounds_({patch.x, patch.z, patch.level - kLodCount + 1}));
      if (nearestGroundDistance(view_, box) > farDistance_ || !mayBeVisible(view_, box)) return;
    }
    if (patch.level > 0 && lod_.lambda(nearestDistance(view_, boxOfPatch(patch))) < patch.level) {
      if (canSplit(patch)) {
        for (int quadrant = 0; quadrant < 4; ++quadrant) visit(childOf(patch, quadrant));
        return;
      }
      ++selection_.coarsened;
    }
    leavesOf(patch).insert(patch);
  }

  // Edges with more than one level between their sides must not be seen: a corner in the middle of a coarse
  // cell's edge would have to move for one neighbour and to stay for the other. So patches beside much finer
  // ones are split as far as there are chunks. From fine to coarse, a split only makes leaves that are still
  // to be looked at.
  void splitBesideFine() {
    for (Leaves& leaves : leaves_) {
      for (const PatchKey& patch : leaves) {
        for (const PatchKey& neighbour : neighboursOf(patch)) {
          std::optional<PatchKey> coarse = leafOver(neighbour);
          while (coarse && coarse->level > patch.level + 1 && canSplit(*coarse)) {
            leavesOf(*coarse).erase(*coarse);
            for (int quadrant = 0; quadrant < 4; ++quadrant) {
              const PatchKey child = childOf(*coarse, quadrant);
              leavesOf(child).insert(child);
            }
            coarse = leafOver(neighbour);
          }
          if (coarse && coarse->level > patch.level + 1) tooFine_.push_back(patch);
        }
      }
    }
  }

  // Where a chunk is missing, what is too fine beside the hole is merged instead, until levels rise by steps
  // of one towards it. Coarse patches whose chunk is missing because nothing of it is in view stay as they
  // are.
  void mergeBesideCoarse() {
    while (!tooFine_.empty()) {
      const PatchKey patch = tooFine_.back();
      tooFine_.pop_back();
      if (!leavesOf(patch).contains(patch)) continue;  // merged meanwhile
      for (const PatchKey& neighbour : neighboursOf(patch)) {
        const std::optional<PatchKey> coarse = leafOver(neighbour);
        if (!coarse || coarse->level <= patch.level + 1 || !misses(*coarse)) continue;
        merge(parentOf(patch));
        break;
      }
    }
  }

  // Whether the chunk that this patch could not be split for is one that the view wants.
  bool misses(const PatchKey& patch) const {
    const ChunkKey chunk = chunkOf(childOf(patch, 0));
    const glm::dvec2 origin = chunkOrigin(chunk);
    const Box box = boxOf(origin, origin + chunkMetres(chunk.level), bounds_(chunk));
    return nearestGroundDistance(view_, box) <= farDistance_ && mayBeVisible(view_, box);
  }

  // Makes a leaf of a patch that has leaves under it, and has all looked at that this may concern: itself,
  // and what is now too fine beside it.
  void merge(const PatchKey& patch) {
    for (std::int32_t level = 0; level < patch.level; ++level) {
      const int up = patch.level - level;
      std::erase_if(leaves_[static_cast<std::size_t>(level)],
                    [&](const PatchKey& leaf) { return leaf.x >> up == patch.x && leaf.z >> up == patch.z; });
    }
    leavesOf(patch).insert(patch);
    ++selection_.coarsened;
    tooFine_.push_back(patch);
    for (std::int32_t level = 0; level + 1 < patch.level; ++level) {
      const int up = patch.level - level;
      for (const PatchKey& leaf : leaves_[static_cast<std::size_t>(level)]) {
        for (const PatchKey& neighbour : neighboursOf(leaf)) {
          if (neighbour.x >> up == patch.x && neighbour.z >> up == patch.z) tooFine_.push_back(leaf);
        }
      }
    }
  }

  static std::array<PatchKey, 4> neighboursOf(const PatchKey& p) {  // in the order of PatchEdge
    return {PatchKey{p.x - 1, p.z, p.level}, PatchKey{p.x + 1, p.z, p.level}, PatchKey{p.x, p.z - 1, p.level},
            PatchKey{p.x, p.z + 1, p.level}};
  }

  // The leaf that is this patch or covers it.
  std::optional<PatchKey> leafOver(PatchKey patch) {
    for (; patch.level <= kTopPatchLevel; patch = parentOf(patch)) {
      if (leavesOf(patch).contains(patch)) return patch;
    }
    return std::nullopt;
  }

  void draw(const PatchKey& patch) {
    const Box box = boxOfPatch(patch);
    // Vertices that are moved along a border can leave the patch by a cell.
    const glm::dvec3 cell(cellMetres(patch.level), 0.0, cellMetres(patch.level));
    if (box.hi.y < floor_ || !mayBeVisible(view_, {box.lo - cell, box.hi + cell})) return;
    const ChunkKey chunk = chunkOf(patch);
    const int step = patch.level - chunk.level;
    const std::int64_t mask = (kPatchesPerChunk >> step) - 1;
    PatchDraw draw;
    draw.level = patch.level;
    draw.x = static_cast<std::int32_t>(box.lo.x - base_.x);
    draw.z = static_cast<std::int32_t>(box.lo.z - base_.y);
    draw.layer = chunks_.at(chunk).layer;
    draw.chunkLevel = chunk.level;
    draw.sampleX = static_cast<std::int32_t>(patch.x & mask) * (kPatchCells << step);
    draw.sampleZ = static_cast<std::int32_t>(patch.z & mask) * (kPatchCells << step);
    draw.distanceM = nearestDistance(view_, box);
    const std::array<PatchKey, 4> neighbours = neighboursOf(patch);
    for (std::size_t edge = 0; edge < neighbours.size(); ++edge) {
      if (const std::optional<PatchKey> leaf = leafOver(neighbours[edge])) {
        draw.coarser[edge] = static_cast<std::uint8_t>(leaf->level - patch.level);
      }
    }
    selection_.patches.push_back(draw);
  }

  const ViewVolume& view_;
  const LodDistances& lod_;
  double farDistance_, floor_;
  glm::dvec2 base_;
  const UsableChunks& chunks_;
  const ChunkBounds& bounds_;
  PatchSelection selection_;
  std::array<Leaves, kTopPatchLevel + 1> leaves_;  // by level
  std::vector<PatchKey> tooFine_;                  // may be beside a patch coarser by more than one level
};

}  // namespace

PatchSelection selectPatches(const ViewVolume& view, const LodDistances& lod, double farDistanceM,
                             double floorM, glm::dvec2 base, const UsableChunks& chunks,
                             const ChunkBounds& bounds) {
  return Selector(view, lod, farDistanceM, floorM, base, chunks, bounds).run();
}

}  // namespace skydrop::terrain
