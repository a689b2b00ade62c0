// What dust and spray cost a frame that shows them, beside the same frame without.
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

using game::BurstKind;

constexpr glm::dvec3 kOpenSea(4400, 0, 4300);

game::SurfaceBurst burstOf(BurstKind kind, const glm::dvec3& at, double seconds, bool onWater) {
  game::SurfaceBurst burst;
  burst.kind = kind;
  burst.position = at;
  burst.seconds = seconds;
  burst.velocity = {20, -8, 0};
  burst.onWater = onWater;
  burst.ground = {0.8, {0.3, 0.25, 0.2}};
  return burst;
}

// Half a second after: a package that fell into the sea 20 m away; a crash 30 m away; a hull that has swum 40
// m.
std::vector<game::SurfaceBurst> happened(const std::string& what, double seconds) {
  std::vector<game::SurfaceBurst> bursts;
  if (what == "package") {
    bursts.push_back(burstOf(BurstKind::package, kOpenSea + glm::dvec3(20, 0, 0), seconds - 0.5, true));
  } else if (what == "crash") {
    bursts.push_back(burstOf(BurstKind::crash, kOpenSea + glm::dvec3(30, 0, 0), seconds - 1.5, false));
  } else {
    for (int i = 0; i < 24; ++i)
      bursts.push_back(burstOf(BurstKind::swimming, kOpenSea + glm::dvec3(20, 0, 1.6 * i - 20),
                               seconds - 2.2 + 0.08 * i, true));
  }
  for (std::size_t i = 0; i < bursts.size(); ++i) bursts[i].number = static_cast<std::uint32_t>(i + 1);
  return bursts;
}

// Frames with the bursts and without in turn in one run: the ratio of medians, by the processor time of all
// threads of the process.
void dustAndSpray(benchmark::State& state, const char* quality, const char* what, double mostShare) {
  BenchGame game({.scene = "lagoon", .set = {std::string("quality=") + quality, "view.hud=false"}});
  app::Pose pose;
  pose.position = {kOpenSea.x, 5, kOpenSea.z};
  pose.pitchDegrees = -6;
  const auto cpuMs = [&] {
    const std::clock_t begin = std::clock();
    game.draw(pose);
    return 1000.0 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  };
  for (auto _ : state) {
    game.settle(pose);
    std::vector<double> with, without;
    const auto bursts = happened(what, game.seconds());
    for (int i = 0; i < 12; ++i) {
      game.show({}), without.push_back(cpuMs());
      game.show(bursts), with.push_back(cpuMs());
    }
    const auto median = [](std::vector<double>& values) {
      std::ranges::sort(values);
      return values[values.size() / 2];
    };
    const double share = median(with) / median(without) - 1;
    state.counters["added"] = share;
    std::printf("%s at quality %s: %.0f %% more, %.1f ms of %.1f\n", what, quality, 100 * share,
                median(with) - median(without), median(without));
    expect(share <= mostShare, "dust and spray add more to a frame than their share");
  }
  state.SetLabel(game.renderer());
}

BENCHMARK_CAPTURE(dustAndSpray, packageLow, "low", "package", 0.15)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(dustAndSpray, packageHigh, "high", "package", 0.15)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(dustAndSpray, crashLow, "low", "crash", 0.15)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(dustAndSpray, crashHigh, "high", "crash", 0.15)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(dustAndSpray, hullLow, "low", "hull", 0.3)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(dustAndSpray, hullHigh, "high", "hull", 0.3)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace skydrop::bench
