// What noise textures cost: kernels of each instruction set against the plain loop over the texels, which
// evaluates the definition at each (NoiseGenerator::valueAt). One thread, values in float; left out: the cut
// to clouds, texels and files.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <string>
#include <vector>

#include "bench/expectation.h"
#include "noise/noise_rows.h"
#include "skydrop/noise/noise_generator.h"

namespace skydrop::noise {
namespace {

constexpr const char* kSetNames[] = {"baseline", "sse41", "avx2", "avx512"};

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

// At most a quarter of the plain loop's time with any instruction set, and the same bits.
void kernelsAgainstThePlainLoop(benchmark::State& state, const NoiseSettings& settings,
                                const NoiseSize& size) {
  const NoiseGenerator generator(settings, size);
  const std::size_t layer = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  std::vector<float> plain(layer * static_cast<std::size_t>(size.layers())), made(plain.size());
  for (auto _ : state) {
    const double plainMs = fastest(
        [&] {
          std::size_t i = 0;
          for (int z = 0; z < size.layers(); ++z) {
            for (int y = 0; y < size.height; ++y) {
              for (int x = 0; x < size.width; ++x) plain[i++] = generator.valueAt(x, y, z);
            }
          }
        },
        2);
    state.counters["plainMs"] = plainMs;
    for (const InstructionSet set : core::kInstructionSets) {
      const OctaveKernels* kernels = octaveKernels(set);
      if (kernels == nullptr) continue;
      const double ms = fastest(
          [&] {
            const NoiseRows rows(settings, size, *kernels);
            for (int z = 0; z < size.layers(); ++z)
              rows.fill(z, 0, std::span(made).subspan(static_cast<std::size_t>(z) * layer, layer));
          },
          5);
      const std::string name = kSetNames[static_cast<std::size_t>(set)];
      state.counters[name + "Ms"] = ms;
      state.counters[name + "Ratio"] = plainMs / ms;
      bench::expect(made == plain, "the noise kernels and the plain loop differ");
      bench::expect(plainMs >= 4 * ms, "the noise kernels take more than a quarter of the plain loop's time");
    }
  }
}

void volumeOfSixOctaves(benchmark::State& state) {
  kernelsAgainstThePlainLoop(state, {.octaves = 6}, {128, 128, 128});
}
BENCHMARK(volumeOfSixOctaves)->Iterations(1)->Unit(benchmark::kMillisecond);

void planeOfTenOctaves(benchmark::State& state) {
  kernelsAgainstThePlainLoop(state, {.octaves = 10}, {1024, 1024, 0});
}
BENCHMARK(planeOfTenOctaves)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace skydrop::noise
