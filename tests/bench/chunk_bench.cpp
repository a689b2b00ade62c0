// What land costs: chunks by each instruction set, single points, bounds. The yardstick is the
// plain loop that asks for one sample after the other. Left out: the cache, the queue and the upload.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>

#include "skydrop/terrain/chunk_data.h"
#include "terrain/noise_source.h"

namespace skydrop::terrain {
namespace {

constexpr const char* kSetNames[] = {"baseline", "sse41", "avx2", "avx512"};
constexpr ChunkKey kKey{4, -6, 0};

ChunkData emptyChunk(const ChunkKey& key) {
  ChunkData chunk;
  chunk.key = key;
  chunk.heights.resize(static_cast<std::size_t>(kChunkSamples) * kChunkSamples);
  chunk.normals.resize(chunk.heights.size());
  return chunk;
}

// Heights and normals of a chunk of the game, on one thread.
void chunkByInstructionSet(benchmark::State& state) {
  const auto set = static_cast<InstructionSet>(state.range(0));
  state.SetLabel(kSetNames[state.range(0)]);
  const RowKernels* kernels = rowKernels(set);
  if (kernels == nullptr) {
    state.SkipWithError("this processor lacks the set");
    return;
  }
  const auto land = makeNoiseHeightSource({}, 1, *kernels);
  ChunkData chunk = emptyChunk({kKey.x, kKey.z, static_cast<std::int32_t>(state.range(1))});
  for (auto _ : state) land->fillChunk(chunk.key, {}, chunk);
}
BENCHMARK(chunkByInstructionSet)->ArgsProduct({{0, 1, 2, 3}, {0, 2, 5}})->Unit(benchmark::kMillisecond);

void chunkPointByPoint(benchmark::State& state) {
  const auto land = makeNoiseHeightSource({}, 1);
  ChunkData chunk = emptyChunk(kKey);
  for (auto _ : state) land->HeightSource::fillChunk(kKey, {}, chunk);
}
BENCHMARK(chunkPointByPoint)->Unit(benchmark::kMillisecond);

// All that a job does: samples and bounds.
void wholeChunk(benchmark::State& state) {
  const auto land = makeNoiseHeightSource({}, 1);
  for (auto _ : state) benchmark::DoNotOptimize(makeChunk(*land, kKey));
}
BENCHMARK(wholeChunk)->Unit(benchmark::kMillisecond);

void onePointOfLand(benchmark::State& state) {
  const auto land = makeNoiseHeightSource({}, 1);
  double x = 0;
  for (auto _ : state) benchmark::DoNotOptimize(land->sample({x += 1.7, 300}));
}
BENCHMARK(onePointOfLand)->Unit(benchmark::kMicrosecond);

void boundsOfChunk(benchmark::State& state) {
  const auto land = makeNoiseHeightSource({}, 1);
  double x = 0;
  for (auto _ : state) {
    x += kChunkMetres;
    benchmark::DoNotOptimize(land->bounds({x, 0}, {x + kChunkMetres, kChunkMetres}));
  }
}
BENCHMARK(boundsOfChunk)->Unit(benchmark::kMicrosecond);

// Asserts the ratios that the design counts on, in processor time: the baseline is at least 15 times as fast
// as the plain loop, and where there is AVX2, the widest set at least 1.5 times as fast as the baseline. The
// best of several runs of each.
void chunkRatios(benchmark::State& state) {
  const auto best = [](const auto& work, int runs) {
    double milliseconds = 1e9;
    for (int i = 0; i < runs; ++i) {
      const std::clock_t start = std::clock();
      work();
      milliseconds = std::min(milliseconds, 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return milliseconds;
  };
  ChunkData chunk = emptyChunk(kKey);
  const auto timeOf = [&](const RowKernels& kernels) {
    const auto land = makeNoiseHeightSource({}, 1, kernels);
    return best([&] { land->fillChunk(kKey, {}, chunk); }, 20);
  };
  for (auto _ : state) {
    const auto land = makeNoiseHeightSource({}, 1);
    const double plain = best([&] { land->HeightSource::fillChunk(kKey, {}, chunk); }, 3);
    const double baseline = timeOf(*rowKernels(InstructionSet::baseline));
    const double widest = timeOf(bestRowKernels());
    state.counters["plainToBaseline"] = plain / baseline;
    state.counters["plainToWidest"] = plain / widest;
    state.counters["baselineToWidest"] = baseline / widest;
    if (plain < 15 * baseline)
      state.SkipWithError("the baseline is less than 15 times as fast as the plain loop");
    if (rowKernels(InstructionSet::avx2) != nullptr && baseline < 1.5 * widest)
      state.SkipWithError("the widest set is less than 1.5 times as fast as the baseline");
  }
}
BENCHMARK(chunkRatios)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace skydrop::terrain
