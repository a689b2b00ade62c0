// What grass, flowers and stones cost a frame that shows them, beside the same frame without.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include "bench/bench_game.h"
#include "bench/expectation.h"

namespace skydrop::bench {
namespace {

// Frames with the effect's density and with none in turn in one run, by the processor time of all threads of
// the process: the ratio of their lower quartiles, which other programs disturb least.
void groundCover(benchmark::State& state, const char* quality, const char* scene, const glm::dvec3& from,
                 const char* density, double mostShare) {
  BenchGame game({.scene = scene,
                  .set = {std::string("quality=") + quality, "view.hud=false", "effects.groundCover=true"}});
  app::Pose pose;
  pose.position = {from.x, game.ground().height({from.x, from.z}) + from.y, from.z};
  pose.yawDegrees = -40;
  pose.pitchDegrees = -12;
  const auto cpuMs = [&] {
    const std::clock_t begin = std::clock();
    game.draw(pose);
    return 1000.0 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  };
  for (auto _ : state) {
    game.settle(pose);
    std::vector<double> with, without;
    for (int i = 0; i < 40; ++i) {
      game.set("groundCover.density=0"), cpuMs(), without.push_back(cpuMs());
      game.set(std::string("groundCover.density=") + density), cpuMs(), with.push_back(cpuMs());
    }
    const auto lowerQuartile = [](std::vector<double>& values) {
      std::ranges::sort(values);
      return values[values.size() / 4];
    };
    const double more = lowerQuartile(with), less = lowerQuartile(without);
    const double share = more / less - 1;
    state.counters["added"] = share;
    std::printf("%s from %.0f m at quality %s: %.0f %% more, %.1f ms of %.1f\n", scene, from.y, quality,
                100 * share, more - less, less);
    expect(share <= mostShare, "what stands on the ground adds more to a frame than its share");
  }
  state.SetLabel(game.renderer());
}

constexpr glm::dvec3 kMeadow(4420, 0, -530), kScree(3000, 0, -3000);

BENCHMARK_CAPTURE(groundCover, meadowAt5Low, "low", "lowlevel", kMeadow + glm::dvec3(0, 5, 0), "0.5", 0.08)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(groundCover, meadowAt20Low, "low", "lowlevel", kMeadow + glm::dvec3(0, 20, 0), "0.5", 0.08)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(groundCover, screeAt5Low, "low", "lowlevel", kScree + glm::dvec3(0, 5, 0), "0.5", 0.08)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(groundCover, meadowAt5High, "high", "lowlevel", kMeadow + glm::dvec3(0, 5, 0), "1", 0.15)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(groundCover, meadowAt20High, "high", "lowlevel", kMeadow + glm::dvec3(0, 20, 0), "1", 0.15)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(groundCover, screeAt5High, "high", "lowlevel", kScree + glm::dvec3(0, 5, 0), "1", 0.15)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace skydrop::bench
