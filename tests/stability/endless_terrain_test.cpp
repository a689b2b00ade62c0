#include "skydrop/terrain/endless_terrain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <condition_variable>
#include <cstdlib>
#include <cstring>
#include <glm/geometric.hpp>
#include <mutex>
#include <new>
#include <set>
#include <thread>
#include <tuple>

#include "skydrop/terrain/chunk_grid.h"
#include "support/hills_source.h"
#include "support/margin.h"

namespace skydrop::terrain {
namespace {

constexpr double kPi = 3.14159265358979323846;

// The land of a wrapped source; counts the chunks that are made, remembers their order, and can hold up or
// fail.
class WatchedSource final : public HeightSource {
 public:
  HeightSample sample(glm::dvec2 xz) const override { return hills_->sample(xz); }
  HeightBounds bounds(glm::dvec2 lo, glm::dvec2 hi) const override { return hills_->bounds(lo, hi); }
  HeightBounds range() const override { return hills_->range(); }

  bool fillChunk(const ChunkKey& key, std::stop_token stop, ChunkData& out) const override {
    {
      std::unique_lock lock(mutex_);
      begun_.push_back(key);
      ++held_;
      opened_.wait(lock, [&] { return open_; });
      --held_;
    }
    if (failing && failing(key)) throw std::bad_alloc();
    // A tenth of the samples is enough of a land for these tests: rows are repeated.
    for (int row = 0; row < kChunkSamples; ++row) {
      if (stop.stop_requested()) return false;
      for (int column = 0; column < kChunkSamples; ++column) {
        const glm::dvec2 at = chunkOrigin(key) + glm::dvec2(column, row - row % 10) * cellMetres(key.level);
        const auto i = static_cast<std::size_t>(sampleIndex(column, row));
        if (row % 10 == 0) {
          out.heights[i] = out.heightRange.encode(hills_->height(at));
        } else {
          out.heights[i] = out.heights[i - kChunkSamples];
        }
        out.normals[static_cast<std::size_t>(normalIndex(column, row))] = encodeNormal({0.0, 0.0});
      }
    }
    return true;
  }

  void close() {
    const std::scoped_lock lock(mutex_);
    open_ = false;
  }
  void open() {
    {
      const std::scoped_lock lock(mutex_);
      open_ = true;
    }
    opened_.notify_all();
  }
  std::vector<ChunkKey> begun() const {
    const std::scoped_lock lock(mutex_);
    return begun_;
  }

  // Workers that are held at the door of a closed source.
  int held() const {
    const std::scoped_lock lock(mutex_);
    return held_;
  }

  std::function<bool(const ChunkKey&)> failing;  // set before the first chunk

 private:
  std::shared_ptr<const HeightSource> hills_ = test::makeHillsSource();
  mutable std::mutex mutex_;
  mutable std::condition_variable opened_;
  mutable std::vector<ChunkKey> begun_;
  mutable int held_ = 0;
  bool open_ = true;
};

ViewVolume lookingAlong(glm::dvec3 eye, double yaw, double pitch, int width = 640, int height = 360) {
  const glm::dvec3 forward{std::cos(yaw) * std::cos(pitch), std::sin(pitch), std::sin(yaw) * std::cos(pitch)};
  const glm::dvec3 right{-std::sin(yaw), 0.0, std::cos(yaw)};
  return makeViewVolume(eye, glm::transpose(glm::dmat3(right, glm::cross(right, forward), -forward)), 1.05,
                        width, height);
}

std::size_t bytesOfUploads(const TerrainFrame& frame) { return frame.uploads.size() * kSampleBytes; }

// What of a frame must not depend on how it came about: all but the layers.
std::vector<std::tuple<int, int, int, int, int, int, double>> drawsOf(const TerrainFrame& frame) {
  std::vector<std::tuple<int, int, int, int, int, int, double>> draws;
  for (const PatchDraw& p : frame.patches) {
    int edges = 0;
    for (const std::uint8_t up : p.coarser) edges = edges * 8 + up;
    draws.emplace_back(p.level, p.x, p.z, p.sampleX, p.sampleZ, edges, p.distanceM);
  }
  return draws;
}

TEST(EndlessTerrain, aSettledFrameDependsOnTheViewAlone) {
  // The same view after a straight start, after a detour over another place with another budget of uploads,
  // and with other numbers of workers: the same patches in the same order.
  const ViewVolume view = lookingAlong({100, 700, -300}, 0.7, -0.1);
  std::vector<std::vector<std::tuple<int, int, int, int, int, int, double>>> frames;
  for (const int workers : {1, 3}) {
    for (const bool detour : {false, true}) {
      core::JobPool pool(workers);
      EndlessTerrain terrain(std::make_shared<WatchedSource>(), pool, {});
      if (detour) {
        terrain.settle(lookingAlong({3000, 300, 5000}, 2.0, -0.4));
        for (int i = 0; i < 20; ++i) terrain.update(lookingAlong({1500.0 + i, 300, 2000}, 0.1 * i, -0.4));
      }
      frames.push_back(drawsOf(terrain.settle(view)));
      EXPECT_TRUE(terrain.isSettled());
      EXPECT_EQ(terrain.statistics().coarsened, 0u);
    }
  }
  ASSERT_FALSE(frames[0].empty());
  for (const auto& frame : frames) EXPECT_EQ(frame, frames[0]);
}

TEST(EndlessTerrain, neighbouringPatchesKnowEachOthersLevels) {
  // The edges of all patches of a view, compared in pairs: the coarser side says 0, the finer side by how
  // much.
  core::JobPool pool(2);
  EndlessTerrain terrain(std::make_shared<WatchedSource>(), pool, {});
  const TerrainFrame& frame = terrain.settle(lookingAlong({100, 400, -300}, 0.7, -0.2));
  const auto sizeOf = [](const PatchDraw& p) { return static_cast<int>(kPatchMetres) << p.level; };
  int pairs = 0, steps = 0;
  for (const PatchDraw& a : frame.patches) {
    for (const PatchDraw& b : frame.patches) {
      const bool touch = a.x + sizeOf(a) == b.x && a.z < b.z + sizeOf(b) && b.z < a.z + sizeOf(a);
      if (!touch) continue;
      ++pairs;
      steps += a.level != b.level;
      EXPECT_EQ(a.coarser[static_cast<int>(PatchEdge::east)], std::max(b.level - a.level, 0));
      EXPECT_EQ(b.coarser[static_cast<int>(PatchEdge::west)], std::max(a.level - b.level, 0));
    }
  }
  EXPECT_GT(pairs, 50);
  EXPECT_GT(steps, 5);
}

TEST(EndlessTerrain, patchesCoverTheGroundOnceAndEveryLevelReachesItsChunksEnd) {
  // Seen from above with a field of view that culls nothing near, the patches tile the ground: areas add up,
  // none overlap; and each takes its samples from inside its chunk.
  core::JobPool pool(2);
  EndlessTerrain terrain(std::make_shared<WatchedSource>(), pool, {});
  const TerrainFrame& frame = terrain.settle(lookingAlong({100, 1500, -300}, 0.7, -kPi / 2));
  std::set<std::pair<int, int>> cells;  // of 60 m
  for (const PatchDraw& p : frame.patches) {
    const int size = 1 << p.level;
    for (int z = 0; z < size; ++z) {
      for (int x = 0; x < size; ++x) {
        EXPECT_TRUE(cells.emplace(p.x / 60 + x, p.z / 60 + z).second) << "overlap at " << p.x << " " << p.z;
      }
    }
    EXPECT_LE(p.sampleX + (kPatchCells << (p.level - p.chunkLevel)), kChunkCells);
    EXPECT_LE(p.sampleZ + (kPatchCells << (p.level - p.chunkLevel)), kChunkCells);
  }
  // No holes where the eye surely looks: 1500 m up it sees at least 780 m to each side.
  const glm::ivec2 below = glm::ivec2(glm::floor((glm::dvec2(100, -300) - frame.base) / kPatchMetres));
  for (int z = -10; z <= 10; ++z) {
    for (int x = -10; x <= 10; ++x) EXPECT_TRUE(cells.contains({below.x + x, below.y + z})) << x << " " << z;
  }
}

TEST(Stability, T08_everyLevelsBoundsEqualTheChunks) {
  // The patches of each skip, side by side, end exactly where the chunk ends.
  test::noFaults("T08", "differences");
  for (const int skip : kLodSkips) {
    static_assert(kChunkCells % (kPatchCells * kLodSkips.back()) == 0);
    const int patches = kChunkCells / (kPatchCells * skip);
    EXPECT_EQ(patches * kPatchCells * skip, kChunkCells);
    EXPECT_EQ(patches * kPatchMetres * skip, kChunkMetres);
  }
}

TEST(Stability, T11_standingStillMakesNothingAgainAndABudgetTooSmallFallsToCoarser) {
  // The working set is n chunks. With room for n everything is drawn as asked; with room for n - 1 and for a
  // third of it the rest is drawn coarser and counted; in no case is a chunk made twice while the view stands
  // still.
  const ViewVolume view = lookingAlong({100, 700, -300}, 0.7, -0.1);
  std::size_t needed = 0;
  {
    core::JobPool pool(2);
    EndlessTerrain terrain(std::make_shared<WatchedSource>(), pool, {});
    terrain.settle(view);
    needed = terrain.statistics().chunksWanted;
    EXPECT_EQ(terrain.statistics().overBudget, 0u);
  }
  constexpr double kSlotMiB = static_cast<double>(kSampleBytes) / 1048576;
  constexpr double kChunkMiB = kSlotMiB + 3000.0 / 1048576;  // with its bookkeeping
  for (const std::size_t room : {needed, needed - 1, needed / 3}) {
    for (const bool onGpu : {false, true}) {
      core::JobPool pool(2);
      auto source = std::make_shared<WatchedSource>();
      TerrainStreamingSettings settings;
      const double budget = (static_cast<double>(room) + 0.5) * (onGpu ? kSlotMiB : kChunkMiB);
      (onGpu ? settings.gpuMiB : settings.cacheMiB) = budget;
      EndlessTerrain terrain(source, pool, settings);
      terrain.settle(view);
      EXPECT_TRUE(terrain.isSettled());
      EXPECT_EQ(terrain.statistics().overBudget, needed - room)
          << "room for " << room << (onGpu ? " on the GPU" : "");
      EXPECT_TRUE(test::holds("T11", terrain.statistics().bytes,
                              test::atMost(static_cast<std::size_t>(settings.cacheMiB * 1048576)), "bytes"));
      EXPECT_GT(terrain.statistics().patches, 10u);
      const std::size_t made = source->begun().size();
      for (int frame = 0; frame < 50; ++frame) {
        EXPECT_TRUE(terrain.update(view).uploads.empty());
        std::this_thread::yield();
      }
      EXPECT_EQ(source->begun().size(), made);
      EXPECT_EQ(terrain.statistics().queue, 0u);
    }
  }
}

TEST(Stability, T11_theDefaultBudgetsHoldTheViewAndAreNeverExceeded) {
  // The shipped settings (10 km) at 1920 x 1080: what a view wants fits into both budgets, of 128 MiB at most
  // each; and after leaps over more land than either can hold, neither holds more.
  const TerrainStreamingSettings settings;
  constexpr std::size_t kMostBytes = std::size_t{128} << 20;
  core::JobPool pool(2);
  EndlessTerrain terrain(std::make_shared<WatchedSource>(), pool, settings);
  for (int leap = 0; leap < 10; ++leap) {
    const TerrainFrame& frame = terrain.settle(lookingAlong({3e4 * leap, 900, 0}, leap, -0.15, 1920, 1080));
    const StreamingStatistics& now = terrain.statistics();
    EXPECT_EQ(now.overBudget, 0u);
    EXPECT_TRUE(test::holds("T11", now.bytes, test::atMost(kMostBytes), "bytes"));
    EXPECT_LE(static_cast<std::size_t>(frame.layerCount) * kSampleBytes, kMostBytes);
    for (const ResidentChunk& chunk : frame.chunks) EXPECT_LT(chunk.layer, frame.layerCount);
  }
  EXPECT_GT(terrain.statistics().generated * kSampleBytes, kMostBytes) << "more than can be held at once";
  EXPECT_GT(terrain.statistics().bytes, kMostBytes / 2);
}

TEST(Stability, T12_aFastFlightKeepsTheQueueBoundedAndTheChunkBelowComesFirst) {
  // 700 m/s and 30 km/s for 10 s at 60 frames a second (a tenth of the frames unless long tests are asked
  // for), with one worker that can never keep up; then a stop. What is no longer wanted is cancelled, so that
  // the first chunk begun after the stop is the one below.
  const int stride = std::getenv("SKYDROP_LONG_TESTS") != nullptr ? 1 : 10;
  for (const double speed : {700.0, 30000.0}) {
    auto source = std::make_shared<WatchedSource>();
    core::JobPool pool(1);
    TerrainStreamingSettings settings;
    EndlessTerrain terrain(source, pool, settings);
    glm::dvec3 eye{50, 950, 50};
    for (int frame = 0; frame < 600; frame += stride) {
      eye.x += speed / 60 * stride;
      terrain.update(lookingAlong(eye, 0, -0.5));
      ASSERT_TRUE(test::holds("T12", pool.statistics().queued,
                              test::atMost(static_cast<std::size_t>(settings.queueLimit)), "jobs"));
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_GT(pool.statistics().cancelled, 0u);
    source->close();
    eye += glm::dvec3(5000, 0, 3000);  // over land that nothing has been made of
    const ViewVolume stop = lookingAlong(eye, 0, -1.2);
    const auto atRest = [&] {  // the worker is held in a chunk that this view does not want, or has no work
      if (source->held() == 1) return true;
      const core::JobStatistics now = pool.statistics();
      return now.queued == 0 && now.running == 0;
    };
    while (!atRest()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const std::vector<ChunkKey> before = source->begun();
    terrain.update(stop);
    source->open();
    terrain.settle(stop);
    const std::vector<ChunkKey> all = source->begun();
    ASSERT_GT(all.size(), before.size());
    EXPECT_EQ(all[before.size()], chunkAt({eye.x, eye.z})) << "at " << speed << " m/s";
  }
}

TEST(Stability, T13_theTerrainMayGoAtAnyMomentWhileItsWorkersAreBusy) {
  // Quit after 0 to 10 frames, 100 times: no chunk that waits is made, and only the running ones are waited
  // for.
  for (int round = 0; round < 100; ++round) {
    auto source = std::make_shared<WatchedSource>();
    std::size_t begun = 0;
    {
      core::JobPool pool(2);
      EndlessTerrain terrain(source, pool, {});
      for (int frame = 0; frame <= round % 11; ++frame) {
        terrain.update(lookingAlong({100.0 * frame, 600, 0}, 0.3 * round, -0.2));
      }
      begun = source->begun().size();
    }
    EXPECT_TRUE(test::holds("T13", source->begun().size(), test::atMost(begun + 4), "jobs"))
        << "two may have begun meanwhile, on each of two workers";
  }
}

TEST(Stability, T14_lookingBackForAFrameUploadsNoMoreThanTheBudget) {
  // A settled view, one frame backwards, forward again: never more bytes in a frame than stated, also while
  // the backward view fills up.
  test::noFaults("T14", "violations");
  core::JobPool pool(2);
  TerrainStreamingSettings settings;
  settings.uploadMiBPerFrame = 1;
  EndlessTerrain terrain(std::make_shared<WatchedSource>(), pool, settings);
  const ViewVolume ahead = lookingAlong({100, 700, -300}, 0, -0.1),
                   back = lookingAlong({100, 700, -300}, kPi, -0.1);
  const auto settled = drawsOf(terrain.settle(ahead));
  const auto withinBudget = [](const TerrainFrame& frame) { return bytesOfUploads(frame) <= 1048576; };
  EXPECT_TRUE(withinBudget(terrain.update(back)));
  const TerrainFrame& again = terrain.update(ahead);
  EXPECT_TRUE(withinBudget(again));
  EXPECT_EQ(drawsOf(again), settled) << "what was there a frame ago is still there";
  for (int frame = 0; frame < 2000 && !terrain.isSettled(); ++frame) {
    EXPECT_TRUE(withinBudget(terrain.update(back)));
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_TRUE(terrain.isSettled());
}

TEST(Stability, T15_aChunkThatCannotBeMadeIsDrawnCoarserAndSaidOnce) {
  // Every chunk of level 0 throws: the land is complete, made of level 1, each failure is reported in one
  // line, and the view counts as settled.
  test::noFaults("T15", "violations");
  auto source = std::make_shared<WatchedSource>();
  source->failing = [](const ChunkKey& key) { return key.level == 0; };
  core::JobPool pool(2);
  EndlessTerrain terrain(source, pool, {});
  const ViewVolume view = lookingAlong({100, 700, -300}, 0.7, -0.3);
  const TerrainFrame& frame = terrain.settle(view);
  ASSERT_TRUE(terrain.isSettled());
  for (const PatchDraw& patch : frame.patches) EXPECT_GE(patch.level, 1);
  EXPECT_GT(terrain.statistics().failures, 0u);
  EXPECT_EQ(terrain.takeMessages().size(), terrain.statistics().failures);
  const std::size_t begun = source->begun().size();
  for (int i = 0; i < 20; ++i) terrain.update(view);
  EXPECT_EQ(source->begun().size(), begun);
  EXPECT_TRUE(terrain.takeMessages().empty());
}

TEST(Stability, T15_aStalledWorkerLeavesTheRestGoingAndNothingHangs) {
  // The workers stall: updates go on, settle() gives up at its limit, and all is well when they come back.
  test::noFaults("T15", "violations");
  auto source = std::make_shared<WatchedSource>();
  core::JobPool pool(1);
  EndlessTerrain terrain(source, pool, {});
  const ViewVolume view = lookingAlong({100, 700, -300}, 0.7, -0.3);
  source->close();
  terrain.settle(view, std::chrono::milliseconds(50));
  EXPECT_FALSE(terrain.isSettled());
  source->open();
  terrain.settle(view);
  EXPECT_TRUE(terrain.isSettled());
}

}  // namespace
}  // namespace skydrop::terrain
