// How soon land is there: in the whole game at 640 x 360, whose drawing takes the processors from the worker
// that makes the chunks. And how many triangles it costs, against rings of fixed detail. Left out: the
// window.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>

#include "bench/bench_game.h"
#include "bench/expectation.h"
#include "skydrop/terrain/chunk_grid.h"

namespace skydrop::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kAltitudeM = 400;

double millisecondsSince(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

app::Pose above(const terrain::HeightSource& ground, glm::dvec2 xz) {
  return {.position = {xz.x, std::max(ground.height(xz), 0.0) + kAltitudeM, xz.y}, .pitchDegrees = -10};
}

// From the begin of the first frame, when the chunk below is asked for, to the begin of the one that uploads
// it and of the one that draws from it, for which its ancestors must be there too. Milliseconds.
struct ChunkBelow {
  double uploadedMs = 0, drawnMs = 0;

  void takeWorse(const ChunkBelow& other) {
    uploadedMs = std::max(uploadedMs, other.uploadedMs);
    drawnMs = std::max(drawnMs, other.drawnMs);
  }
};

ChunkBelow waitForChunkBelow(BenchGame& game, const app::Pose& pose) {
  const terrain::ChunkKey below = terrain::chunkAt({pose.position.x, pose.position.z});
  ChunkBelow waited;
  bool uploaded = false;
  const auto request = Clock::now();
  while (true) {
    const double begin = millisecondsSince(request);
    game.draw(pose);
    const terrain::TerrainFrame& frame = game.land().frame();
    const bool uploads = std::any_of(frame.uploads.begin(), frame.uploads.end(),
                                     [&](const auto& upload) { return upload.data->key == below; });
    if (uploads && !uploaded) waited.uploadedMs = begin;
    uploaded = uploaded || uploads;
    waited.drawnMs = begin;
    if (std::any_of(frame.chunks.begin(), frame.chunks.end(),
                    [&](const auto& chunk) { return chunk.key == below; }))
      return waited;
  }
}

// From nothing, 500 km from where anything has been made, to all that the view shows.
void coldStart(benchmark::State& state) {
  double worst = 0;
  BenchGame game({});
  double place = 0;
  for (auto _ : state) {
    const app::Pose pose = above(game.ground(), {place += 5e5, 0});
    const auto begin = Clock::now();
    game.settle(pose);
    worst = std::max(worst, millisecondsSince(begin));
    state.counters["chunks"] = static_cast<double>(game.land().statistics().chunksWanted);
  }
  state.counters["worstMs"] = worst;
  expect(worst < 2000, "a cold start took more than 2 s");
}
BENCHMARK(coldStart)->Iterations(10)->Unit(benchmark::kMillisecond)->UseRealTime();

// The chunk below is uploaded before the first frame that begins 100 ms after it was asked for: in 40 leaps
// of 20 km, with all that the view needs besides still to be made.
void chunkBelowAfterALeap(benchmark::State& state) {
  ChunkBelow worst;
  BenchGame game({});
  double place = 0;
  for (auto _ : state) {
    const app::Pose pose = above(game.ground(), {0, place += 2e4});
    worst.takeWorse(waitForChunkBelow(game, pose));
    game.settle(pose);
  }
  state.counters["uploadedMs"] = worst.uploadedMs;
  state.counters["drawnMs"] = worst.drawnMs;
  expect(worst.uploadedMs < 100, "the chunk below came later than 100 ms after its request");
}
BENCHMARK(chunkBelowAfterALeap)->Iterations(40)->Unit(benchmark::kMillisecond)->UseRealTime();

// Hard case T12: after two seconds at 30 km/s, with jobs under way for land that has long gone by, the chunk
// below the place of the stop is there within a quarter of a second.
void chunkBelowAfterAStop(benchmark::State& state) {
  constexpr double kSpeedMps = 30000;
  ChunkBelow worst;
  BenchGame game({});
  glm::dvec2 place{0, 0};
  for (auto _ : state) {
    const auto begin = Clock::now();
    const double from = place.x;
    app::Pose pose;
    do {
      place.x = from + kSpeedMps * millisecondsSince(begin) / 1000;
      pose = above(game.ground(), place);
      game.draw(pose);
    } while (millisecondsSince(begin) < 2000);
    worst.takeWorse(waitForChunkBelow(game, pose));
  }
  state.counters["uploadedMs"] = worst.uploadedMs;
  state.counters["drawnMs"] = worst.drawnMs;
  expect(worst.drawnMs < 250, "the chunk below came later than 0.25 s after the stop");
}
BENCHMARK(chunkBelowAfterAStop)->Iterations(5)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace skydrop::bench
