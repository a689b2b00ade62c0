#include "terrain/chunk_selection.h"

#include <algorithm>
#include <limits>

namespace skydrop::terrain {
namespace {

// After all that is in view.
constexpr double kUrgencyOutOfView = std::numeric_limits<double>::max();

class Selector {
 public:
  Selector(const ViewVolume& view, const LodDistances& lod, double farDistance, const ChunkBounds& bounds)
      : view_(view), lod_(lod), farDistance_(farDistance), bounds_(bounds) {}

  std::vector<WantedChunk> run() {
    const double reach = farDistance_;
    const glm::dvec2 eye{view_.position.x, view_.position.z};
    const ChunkKey lo = chunkAt(eye - reach, kMaxChunkLevel), hi = chunkAt(eye + reach, kMaxChunkLevel);
    for (std::int64_t z = lo.z; z <= hi.z; ++z) {
      for (std::int64_t x = lo.x; x <= hi.x; ++x) visit({x, z, kMaxChunkLevel});
    }
    std::stable_sort(chosen_.begin(), chosen_.end(),
                     [](const Chosen& a, const Chosen& b) { return a.urgency < b.urgency; });
    std::vector<WantedChunk> wanted;
    wanted.reserve(chosen_.size());
    for (const Chosen& c : chosen_) wanted.push_back(c.chunk);
    return wanted;
  }

 private:
  struct Chosen {
    WantedChunk chunk;
    double urgency;
  };

  void visit(const ChunkKey& key) {
    const glm::dvec2 origin = chunkOrigin(key);
    const double size = chunkMetres(key.level);
    const Box box = boxOf(origin, origin + size, bounds_(key));
    const double ground = nearestGroundDistance(view_, box);
    if (ground > farDistance_) return;
    if (!mayBeVisible(view_, box)) {
      if (key.level == kMaxChunkLevel) chosen_.push_back({{key, false, false}, kUrgencyOutOfView});
      return;
    }
    const double distance = nearestDistance(view_, box);
    const bool split = key.level > 0 && distance < lod_.split[static_cast<std::size_t>(key.level)];
    const double urgency = ground > 0 ? distance / size : key.level - 1.0 - kMaxChunkLevel;
    const std::size_t self = chosen_.size();
    chosen_.push_back({{key, true, true}, urgency});
    if (!split) return;
    for (int quadrant = 0; quadrant < 4; ++quadrant) visit(childOf(key, quadrant));
    chosen_[self].chunk.finest = chosen_.size() == self + 1;
  }

  const ViewVolume& view_;
  const LodDistances& lod_;
  double farDistance_;
  const ChunkBounds& bounds_;
  std::vector<Chosen> chosen_;
};

}  // namespace

std::vector<WantedChunk> selectChunks(const ViewVolume& view, const LodDistances& lod, double farDistanceM,
                                      const ChunkBounds& bounds) {
  return Selector(view, lod, farDistanceM, bounds).run();
}

}  // namespace skydrop::terrain
