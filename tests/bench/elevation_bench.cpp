// What land from elevation data costs, against noise land.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <memory>

#include "bench/expectation.h"
#include "skydrop/elevation/elevation_height_source.h"
#include "skydrop/terrain/chunk_data.h"
#include "skydrop/terrain/noise_height_source.h"
#include "support/elevation_files.h"
#include "support/temporary_folder.h"

namespace skydrop::elevation {
namespace {

using bench::expect;

// Processor time of one run, ms.
template <class Work>
double once(const Work& work) {
  const std::clock_t start = std::clock();
  work();
  return 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

// A tile of 3601 x 3601 posts of 30 m around 46.5 north, 7.5 east.
std::string writeSrtm(const test::TemporaryFolder& folder) {
  return folder.write(
      "N46E007.hgt", test::srtmBytes(3601, [](int c, int r) {
        return static_cast<int>(1500 + 900 * std::sin(c / 90.0) * std::cos(r / 70.0) + (c * 7 + r * 13) % 9);
      }));
}

// The chunk of a level around a place of the world.
terrain::ChunkKey chunkAt(double x, double z, std::int32_t level) {
  const double size = terrain::chunkMetres(level);
  return {static_cast<std::int32_t>(std::floor(x / size)), static_cast<std::int32_t>(std::floor(z / size)),
          level};
}

void compareWithNoise(benchmark::State& state, const terrain::HeightSource& land,
                      const terrain::HeightSource& noise, const terrain::ChunkKey& key) {
  for (auto _ : state) {
    std::vector<double> ofNoise, ofLand;
    for (int i = 0; i < 15; ++i) {
      ofNoise.push_back(once([&] { benchmark::DoNotOptimize(terrain::makeChunk(noise, key)); }));
      ofLand.push_back(once([&] { benchmark::DoNotOptimize(terrain::makeChunk(land, key)); }));
    }
    std::sort(ofNoise.begin(), ofNoise.end());
    std::sort(ofLand.begin(), ofLand.end());
    state.counters["noiseMs"] = ofNoise[7];
    state.counters["elevationMs"] = ofLand[7];
    state.counters["ratio"] = ofLand[7] / ofNoise[7];
    expect(ofLand[7] <= 2 * ofNoise[7],
           "a chunk of elevation data takes more than twice as long as one of noise");
  }
}

// A chunk of elevation data takes at most twice as long as one of noise land; processor time, medians of
// interleaved runs.
void elevationChunk(benchmark::State& state) {
  const test::TemporaryFolder folder;
  const auto noise = terrain::makeNoiseHeightSource({}, 1);
  const auto land =
      makeElevationHeightSource({openRaster(writeSrtm(folder))}, {false, 46.5, 7.5, 4000}, noise);
  compareWithNoise(state, *land, *noise, chunkAt(1, 1, static_cast<std::int32_t>(state.range(0))));
}
BENCHMARK(elevationChunk)->Arg(0)->Arg(2)->Arg(5)->Iterations(1)->Unit(benchmark::kMillisecond);

// So does one in which the data fade into the land around, which is made of both.
void elevationFadingChunk(benchmark::State& state) {
  const test::TemporaryFolder folder;
  const auto noise = terrain::makeNoiseHeightSource({}, 1);
  const auto land =
      makeElevationHeightSource({openRaster(writeSrtm(folder))}, {false, 46.5, 7.5, 4000}, noise);
  double edge = 0;
  while (land->hasData({edge, 1})) edge += 100;
  compareWithNoise(state, *land, *noise, chunkAt(edge + 2000, 1, static_cast<std::int32_t>(state.range(0))));
}
BENCHMARK(elevationFadingChunk)->Arg(0)->Arg(2)->Arg(5)->Iterations(1)->Unit(benchmark::kMillisecond);

// A tile of 3601 x 3601 is opened, looked through and has its first chunks within a second, and keeps at most
// 64 MiB.
void elevationStart(benchmark::State& state) {
  const test::TemporaryFolder folder;
  const std::string file = writeSrtm(folder);
  const auto noise = terrain::makeNoiseHeightSource({}, 1);
  for (auto _ : state) {
    std::shared_ptr<const ElevationHeightSource> land;
    const double openMs = once([&] {
      land = makeElevationHeightSource({openRaster(file)}, {false, 46.5, 7.5, 4000}, noise);
    });
    const double chunksMs = once([&] {
      for (std::int32_t level = 0; level <= terrain::kMaxChunkLevel; ++level) {
        for (const auto& [x, z] : {std::pair(0, 0), {-1, 0}, {0, -1}, {-1, -1}})
          benchmark::DoNotOptimize(terrain::makeChunk(*land, {x, z, level}));
      }
    });
    state.counters["openMs"] = openMs;
    state.counters["chunksMs"] = chunksMs;
    state.counters["keptMiB"] = static_cast<double>(land->keptBytes()) / 1048576;
    expect(openMs + chunksMs < 1000, "a tile of 3601 posts is not flown over a second after the start");
    expect(land->keptBytes() <= std::size_t{64} << 20, "a tile keeps more than 64 MiB");
  }
}
BENCHMARK(elevationStart)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace skydrop::elevation
