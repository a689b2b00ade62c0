#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <set>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "skydrop/terrain/analytic_height_sources.h"
#include "skydrop/terrain/view_volume.h"
#include "support/hills_source.h"
#include "support/instrumented.h"
#include "support/margin.h"
#include "terrain/chunk_selection.h"

namespace skydrop::terrain {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kFarDistanceM = 12000;
constexpr double kFovYRad = 1.05;

// Yaw 0 looks along +x, pitch up, then roll to the right about the view axis.
glm::dmat3 lookDirection(double yaw, double pitch, double roll) {
  const glm::dvec3 forward{std::cos(yaw) * std::cos(pitch), std::sin(pitch), std::sin(yaw) * std::cos(pitch)};
  const glm::dvec3 right{-std::sin(yaw), 0.0, std::cos(yaw)};
  const glm::dvec3 up = glm::cross(right, forward);
  const glm::dvec3 rolledRight = right * std::cos(roll) - up * std::sin(roll);
  const glm::dvec3 rolledUp = glm::cross(rolledRight, forward);
  return glm::transpose(glm::dmat3(rolledRight, rolledUp, -forward));
}

LodDistances testLod(const ViewVolume& view) {
  return makeLodDistances(ReliefErrors{}, view.pixelsPerRadian, TerrainStreamingSettings{});
}

// The oracle: it culls nothing by boxes. It walks all chunks that the distance asks for and calls one visible
// if one of 33 x 33 points of its surface is inside the four sides, or if a point between them is: the
// surface is sampled again, 16 times as densely, around points that are nearly inside.
class Oracle {
 public:
  explicit Oracle(const HeightSource& source) : source_(source) {}

  std::vector<ChunkKey> visibleChunks(const ViewVolume& view, const LodDistances& lod) {
    std::vector<ChunkKey> found;
    const glm::dvec2 eye{view.position.x, view.position.z};
    const ChunkKey lo = chunkAt(eye - kFarDistanceM, kMaxChunkLevel);
    const ChunkKey hi = chunkAt(eye + kFarDistanceM, kMaxChunkLevel);
    for (auto z = lo.z; z <= hi.z; ++z) {
      for (auto x = lo.x; x <= hi.x; ++x) walk({x, z, kMaxChunkLevel}, view, lod, found);
    }
    return found;
  }

 private:
  struct Surface {
    std::vector<glm::dvec3> points;
    glm::dvec3 centre;
    double radius = 0;
    Box box;
  };
  static constexpr int kPoints = 33;

  const Surface& surfaceOf(const ChunkKey& key) {
    Surface& s = surfaces_[key];
    if (!s.points.empty()) return s;
    const glm::dvec2 origin = chunkOrigin(key);
    const double step = chunkMetres(key.level) / (kPoints - 1);
    for (int z = 0; z < kPoints; ++z) {
      for (int x = 0; x < kPoints; ++x) {
        const glm::dvec2 at = origin + glm::dvec2(x, z) * step;
        s.points.emplace_back(at.x, source_.height(at), at.y);
      }
    }
    s.centre = s.points[kPoints * (kPoints / 2) + kPoints / 2];
    for (const glm::dvec3& p : s.points) s.radius = std::max(s.radius, glm::distance(p, s.centre));
    s.radius += step;
    s.box = boxOf(origin, origin + chunkMetres(key.level),
                  source_.bounds(origin, origin + chunkMetres(key.level)));
    return s;
  }

  static double depthInside(const ViewVolume& view, const glm::dvec3& point) {
    double least = 1e30;
    for (const glm::dvec3& n : view.inward) least = std::min(least, glm::dot(n, point - view.position));
    return least;
  }

  bool seen(const ChunkKey& key, const ViewVolume& view) {
    const Surface& s = surfaceOf(key);
    if (depthInside(view, s.centre) < -s.radius) return false;
    const double step = chunkMetres(key.level) / (kPoints - 1);
    for (const glm::dvec3& p : s.points) {
      if (depthInside(view, p) >= 0) return true;
    }
    const glm::dvec2 origin = chunkOrigin(key), end = origin + chunkMetres(key.level);
    for (const glm::dvec3& p : s.points) {
      if (depthInside(view, p) < -step) continue;
      for (int z = -2; z <= 2; ++z) {
        for (int x = -2; x <= 2; ++x) {
          const glm::dvec2 at = glm::clamp(glm::dvec2(p.x, p.z) + glm::dvec2(x, z) * (step / 4), origin, end);
          if (depthInside(view, {at.x, source_.height(at), at.y}) >= 0) return true;
        }
      }
    }
    return false;
  }

  void walk(const ChunkKey& key, const ViewVolume& view, const LodDistances& lod,
            std::vector<ChunkKey>& found) {
    const Box& box = surfaceOf(key).box;
    if (nearestGroundDistance(view, box) > kFarDistanceM) return;
    if (key.level > 0 && nearestDistance(view, box) < lod.split[static_cast<std::size_t>(key.level)]) {
      for (int quadrant = 0; quadrant < 4; ++quadrant) walk(childOf(key, quadrant), view, lod, found);
    } else if (seen(key, view)) {
      found.push_back(key);
    }
  }

  const HeightSource& source_;
  std::unordered_map<ChunkKey, Surface, ChunkKeyHash> surfaces_;
};

std::set<std::tuple<int, std::int64_t, std::int64_t>> finestOf(const std::vector<WantedChunk>& wanted) {
  std::set<std::tuple<int, std::int64_t, std::int64_t>> keys;
  for (const WantedChunk& chunk : wanted) {
    if (chunk.finest) keys.emplace(chunk.key.level, chunk.key.x, chunk.key.z);
  }
  return keys;
}

TEST(Stability, T09_noVisibleChunkIsCulledAndFewInvisibleOnesAreDrawn) {
  // 1e5 random poses, half of them within a metre of a chunk border: every chunk in which the oracle sees
  // land is chosen, and the chosen ones are at most 1.6 times the seen ones.
  const auto source = test::makeHillsSource();
  const ChunkBounds bounds = [&](const ChunkKey& key) {
    const glm::dvec2 origin = chunkOrigin(key);
    return source->bounds(origin, origin + chunkMetres(key.level));
  };
  Oracle oracle(*source);
  core::RandomStream random{9, 0};
  std::size_t drawn = 0, seen = 0, missed = 0;
  constexpr int kPoses = test::repetitions(100000);
  for (int pose = 0; pose < kPoses; ++pose) {
    glm::dvec2 at{(random.nextUnit() - 0.5) * 6000, (random.nextUnit() - 0.5) * 6000};
    if (pose % 2 == 0) at.x = std::round(at.x / 960) * 960 + random.nextUnit() * 2 - 1;
    const double altitude = std::pow(10.0, 0.3 + 3.2 * random.nextUnit());
    const glm::dvec3 eye{at.x, source->height(at) + altitude, at.y};
    // Pitches as in flight: most near the horizon, some to the zenith and the nadir.
    const double pitch = (random.nextUnit() - 0.5) * (pose % 4 == 0 ? kPi : 1.2);
    const ViewVolume view = makeViewVolume(
        eye, lookDirection(random.nextUnit() * 2 * kPi, pitch, (random.nextUnit() - 0.5) * 2 * kPi), kFovYRad,
        320, 180);
    const LodDistances lod = testLod(view);
    const auto chosen = finestOf(selectChunks(view, lod, kFarDistanceM, bounds));
    const std::vector<ChunkKey> visible = oracle.visibleChunks(view, lod);
    for (const ChunkKey& key : visible) missed += !chosen.contains({key.level, key.x, key.z});
    drawn += chosen.size();
    seen += visible.size();
  }
  EXPECT_EQ(missed, 0u);
  EXPECT_TRUE(test::holds("T09", static_cast<double>(drawn), test::atMost(1.6 * static_cast<double>(seen)),
                          "chunks drawn"))
      << drawn << " drawn, " << seen << " seen";
  RecordProperty("drawnPerSeen", std::to_string(static_cast<double>(drawn) / static_cast<double>(seen)));
}

TEST(Stability, T10_straightDownUpAndUpsideDownDrawExactlyWhatIsSeen) {
  // Over flat ground, with the picture's edges along the axes, boxes are exact: the drawn set is the
  // oracle's. Straight up there is nothing to draw. No comparison with NaN can hold, so equality proves there
  // is none.
  test::noFaults("T10", "differences");
  const auto source = makeFlatSource(100);
  const ChunkBounds bounds = [](const ChunkKey&) { return HeightBounds{100, 100}; };
  Oracle oracle(*source);
  for (const double yaw : {0.0, kPi / 2, kPi}) {
    for (const double roll : {0.0, kPi}) {
      for (const glm::dvec3 eye :
           {glm::dvec3(480, 2000, 480), glm::dvec3(0, 600, 0), glm::dvec3(-1, 3000, 7)}) {
        for (const double pitch : {-kPi / 2, kPi / 2}) {
          const ViewVolume view = makeViewVolume(eye, lookDirection(yaw, pitch, roll), kFovYRad, 320, 180);
          const LodDistances lod = testLod(view);
          std::set<std::tuple<int, std::int64_t, std::int64_t>> visible;
          for (const ChunkKey& key : oracle.visibleChunks(view, lod))
            visible.emplace(key.level, key.x, key.z);
          const auto chosen = finestOf(selectChunks(view, lod, kFarDistanceM, bounds));
          EXPECT_EQ(chosen, visible) << "yaw " << yaw << " roll " << roll << " pitch " << pitch;
          EXPECT_EQ(visible.empty(), pitch > 0);
        }
      }
    }
  }
}

TEST(Culling, viewsBesideAddWhatTheySee) {
  // Of two views one beside the other all chunks are chosen that either wants, at the detail of the first;
  // one that sees no land adds nothing.
  const auto source = makeFlatSource(100);
  const ChunkBounds bounds = [](const ChunkKey&) { return HeightBounds{100, 100}; };
  const auto looking = [](double yaw, double pitch) {
    return makeViewVolume({480, 600, 480}, lookDirection(yaw, pitch, 0), kFovYRad, 320, 180);
  };
  const ViewVolume ahead = looking(0, -0.2), back = looking(kPi, -0.2);
  const LodDistances lod = testLod(ahead);
  const auto chosen = [&](const ViewVolume& view) {
    return finestOf(selectChunks(view, lod, kFarDistanceM, bounds));
  };
  ViewVolume both = ahead;
  both.beside = {back};
  const auto all = chosen(both);
  for (const auto& one : {chosen(ahead), chosen(back)})
    for (const auto& key : one) EXPECT_TRUE(all.contains(key));
  EXPECT_GT(all.size(), chosen(ahead).size());
  both.beside = {looking(0, kPi / 2)};
  EXPECT_EQ(chosen(both), chosen(ahead));
}

}  // namespace
}  // namespace skydrop::terrain
