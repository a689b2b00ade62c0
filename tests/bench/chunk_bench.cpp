// What land costs: chunks by each instruction set, single points, bounds. The yardstick is the
// plain loop that asks for one sample after the other. Left out: the cache, the queue and the upload.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <memory>
#include <string>

#include "bench/expectation.h"
#include "skydrop/terrain/chunk_data.h"
#include "skydrop/terrain/chunk_key.h"
#include "terrain/lattice_noise.h"
#include "terrain/noise_source.h"
#include "terrain/row_kernels.h"

namespace skydrop::terrain {
namespace {

using bench::expect;

constexpr const char* kSetNames[] = {"baseline", "sse41", "avx2", "avx512"};
constexpr ChunkKey kKey{4, -6, 0};

ChunkData emptyChunk(const ChunkKey& key) {
  ChunkData chunk;
  chunk.key = key;
  chunk.heights.resize(static_cast<std::size_t>(kChunkSamples) * kChunkSamples);
  chunk.normals.resize(static_cast<std::size_t>(kNormalSide) * kNormalSide);
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

// A sum of eight octaves over a chunk through the kernels of the land, without the land's shape: what a chunk
// costs in the terms of other libraries. Cells of 1024 to 8 m, each amplitude half the one before.
class EightOctaves {
 public:
  static constexpr int kOctaves = 8;

  EightOctaves() {
    for (int i = 0; i < kOctaves; ++i)
      lattices_[static_cast<std::size_t>(i)] =
          makeLattice(1024.0 / (1 << i), i, static_cast<std::uint64_t>(i));
  }

  // Sample by sample, as one would write it first.
  void fillPlainly(const ChunkKey& key, ChunkData& out) const {
    const glm::dvec2 origin = chunkOrigin(key);
    for (int row = 0; row < kChunkSamples; ++row) {
      for (int column = 0; column < kChunkSamples; ++column) {
        const Jet<double> height = at(origin + kCellMetres * glm::dvec2(column, row));
        const auto i = static_cast<std::size_t>(sampleIndex(column, row));
        out.heights[i] = out.heightRange.encode(height.v);
        out.normals[static_cast<std::size_t>(normalIndex(column, row))] = encodeNormal({height.x, height.z});
      }
    }
  }

  Jet<double> at(glm::dvec2 xz) const {
    Jet<double> sum{};
    double amplitude = 1;
    for (const Lattice& lattice : lattices_) {
      const Jet<double> noise = noiseAt(lattice, xz.x, xz.y);
      sum.v += amplitude * noise.v;
      sum.x += amplitude * noise.x;
      sum.z += amplitude * noise.z;
      amplitude /= 2;
    }
    return sum;
  }

  // Row by row. Returns the largest difference to at(), looked up on the diagonal if `checks`.
  double fill(const RowKernels& kernels, const ChunkKey& key, ChunkData& out, bool checks = false) const {
    const glm::dvec2 origin = chunkOrigin(key);
    const auto octaves = std::make_unique<std::array<Octave, kOctaves>>();
    const auto state = std::make_unique<RowState>();
    const LandShape<float> shape{TerrainSettings{}};
    double amplitude = 1, worst = 0;
    for (std::size_t i = 0; i < kOctaves; ++i, amplitude /= 2)
      (*octaves)[i].begin(lattices_[i], origin.x, amplitude);
    JetRow& sum = state->land.detail;
    for (int row = 0; row < kChunkSamples; ++row) {
      for (std::size_t i = 0; i < kOctaves; ++i) {
        const OctaveRow& octave =
            (*octaves)[i].enter(lattices_[i], origin.y + row * kCellMetres, row == 0, kernels);
        (i == 0 ? kernels.storeNoise : kernels.addNoise)(octave, sum);
      }
      kernels.finish(shape, *state, kChunkSamples, out.heights.data() + sampleIndex(0, row),
                     out.normals.data() + normalIndex(0, row));
      if (!checks) continue;
      const Jet<double> exact = at(origin + kCellMetres * glm::dvec2(row, row));
      worst = std::max({worst, std::abs(exact.v - sum.v.samples()[row]),
                        std::abs(exact.x - sum.x.samples()[row]), std::abs(exact.z - sum.z.samples()[row])});
    }
    return worst;
  }

 private:
  // As GridOctave of noise_chunk.cpp, for samples of level 0 and cells of at least two of them.
  struct Octave {
    OctaveRow row;
    std::int64_t firstNode = 0, latticeRow = 0;
    std::array<float, 512> u{}, fades{}, slopes{};
    std::array<NodeRow, 2> nodes{};
    std::size_t north = 0;

    void begin(const Lattice& lattice, double x, double amplitude) {
      const double at = x / lattice.cell + lattice.offsetX, step = kCellMetres / lattice.cell;
      firstNode = static_cast<std::int64_t>(std::floor(at));
      const double inCell = at - std::floor(at);
      row.perCell = static_cast<int>(1 / step);
      row.phase = static_cast<int>(inCell / step);
      row.cells = (kChunkSamples + row.phase + row.perCell - 1) / row.perCell;
      for (int k = 0; k < row.perCell; ++k) {
        const auto i = static_cast<std::size_t>(k);
        u[i] = static_cast<float>(inCell + (k - row.phase) * step);
        fades[i] = fade(u[i]);
        slopes[i] = fadeSlope(u[i]);
      }
      row.u = u.data();
      row.fade = fades.data();
      row.fadeSlope = slopes.data();
      row.amplitude = static_cast<float>(kNoiseScale * amplitude);
      row.perMetre = static_cast<float>(1 / lattice.cell);
    }

    const OctaveRow& enter(const Lattice& lattice, double z, bool first, const RowKernels& kernels) {
      const double at = z / lattice.cell + lattice.offsetZ;
      const auto j = static_cast<std::int64_t>(std::floor(at));
      if (first || j != latticeRow) {
        latticeRow = j;
        north = first ? 0 : 1 - north;
        if (first) kernels.nodes(lattice.rowSeed(j), firstNode, 1, row.cells + 1, nodes[north]);
        kernels.nodes(lattice.rowSeed(j + 1), firstNode, 1, row.cells + 1, nodes[1 - north]);
        const NodeRow &n = nodes[north], &s = nodes[1 - north];
        row.northWestX = n.x.data(), row.northWestZ = n.z.data();
        row.northEastX = n.x.data() + 1, row.northEastZ = n.z.data() + 1;
        row.southWestX = s.x.data(), row.southWestZ = s.z.data();
        row.southEastX = s.x.data() + 1, row.southEastZ = s.z.data() + 1;
      }
      row.w = static_cast<float>(at - std::floor(at));
      row.fadeZ = fade(row.w);
      row.fadeSlopeZ = fadeSlope(row.w);
      return row;
    }
  };

  std::array<Lattice, kOctaves> lattices_;
};

// Processor time of the fastest of several runs, ms.
template <class Work>
double fastest(const Work& work, int runs) {
  double milliseconds = 1e9;
  for (int i = 0; i < runs; ++i) {
    const std::clock_t start = std::clock();
    work();
    milliseconds = std::min(milliseconds, 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return milliseconds;
}

// Heights and analytic normals of a chunk of eight octaves on one thread: at least 12 times as fast as the
// plain loop with 8 float lanes, 3 times with SSE4.1.
void eightOctaves(benchmark::State& state) {
  const EightOctaves noise;
  ChunkData chunk = emptyChunk(kKey);
  for (auto _ : state) {
    const double plain = fastest([&] { noise.fillPlainly(kKey, chunk); }, 5);
    state.counters["plainMs"] = plain;
    for (const InstructionSet set : kInstructionSets) {
      const RowKernels* kernels = rowKernels(set);
      if (kernels == nullptr) continue;
      const double ms = fastest([&] { noise.fill(*kernels, kKey, chunk); }, 50);
      const std::string name = kSetNames[static_cast<std::size_t>(set)];
      state.counters[name + "Ms"] = ms;
      state.counters[name + "Ratio"] = plain / ms;
      expect(noise.fill(*kernels, kKey, chunk, true) < 2e-6, "the kernels and the plain loop differ");
      if (set == InstructionSet::sse41)
        expect(plain >= 3 * ms, "SSE4.1 is less than 3 times as fast as the plain loop");
      if (set == InstructionSet::avx2)
        expect(plain >= 12 * ms, "8 lanes are less than 12 times as fast as the plain loop");
    }
  }
}
BENCHMARK(eightOctaves)->Iterations(1)->Unit(benchmark::kMillisecond);

// Asserts the ratios that the design counts on, in processor time: the baseline is at least 12 times as fast
// as the plain loop, and where there is AVX2, the widest set at least 1.5 times as fast as the baseline. The
// best of several runs of each.
void chunkRatios(benchmark::State& state) {
  ChunkData chunk = emptyChunk(kKey);
  const auto timeOf = [&](const RowKernels& kernels) {
    const auto land = makeNoiseHeightSource({}, 1, kernels);
    return fastest([&] { land->fillChunk(kKey, {}, chunk); }, 20);
  };
  for (auto _ : state) {
    const auto land = makeNoiseHeightSource({}, 1);
    const double plain = fastest([&] { land->HeightSource::fillChunk(kKey, {}, chunk); }, 3);
    const double baseline = timeOf(*rowKernels(InstructionSet::baseline));
    const double widest = timeOf(bestRowKernels());
    state.counters["plainToBaseline"] = plain / baseline;
    state.counters["plainToWidest"] = plain / widest;
    state.counters["baselineToWidest"] = baseline / widest;
    expect(plain >= 12 * baseline, "the baseline is less than 12 times as fast as the plain loop");
    expect(rowKernels(InstructionSet::avx2) == nullptr || baseline >= 1.5 * widest,
           "the widest set is less than 1.5 times as fast as the baseline");
  }
}
BENCHMARK(chunkRatios)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace skydrop::terrain
