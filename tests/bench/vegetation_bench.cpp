// What trees cost a frame.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "bench/bench_game.h"
#include "bench/expectation.h"

namespace skydrop::bench {
namespace {

constexpr int kRounds = 12;

double medianOf(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
  return values[values.size() / 2];
}

// Frames of a path over dense woods, 50 m up, with trees and without, in turn in one run: the median of their
// ratios. Standing trees also change the land's pass, so whole frames count.
void trees(benchmark::State& state, const char* quality, double mostShare) {
  const auto settings = [&](const char* on) {
    return std::vector<std::string>{std::string("quality=") + quality,
                                    std::string("effects.vegetation=") + on, "view.hud=false"};
  };
  BenchGame with({.scene = "woodland", .set = settings("true")});
  BenchGame without({.scene = "woodland", .set = settings("false")});
  app::Pose pose;
  pose.yawDegrees = 200;
  pose.pitchDegrees = -12;
  for (auto _ : state) {
    std::vector<double> shares, added;
    for (int round = 0; round < kRounds; ++round) {
      const glm::dvec2 at(-1600 - 40.0 * round, -3300 + 30.0 * round);
      pose.position = {at.x, with.ground().height(at) + 50, at.y};
      for (BenchGame* game : {&with, &without}) game->settle(pose), game->draw(pose);
      std::vector<double> on, off;
      for (int i = 0; i < 5; ++i) off.push_back(without.draw(pose)), on.push_back(with.draw(pose));
      shares.push_back(medianOf(on) / medianOf(off) - 1);
      added.push_back(medianOf(on) - medianOf(off));
    }
    const double share = medianOf(shares);
    state.counters["added"] = share;
    state.counters["addedMs"] = medianOf(added);
    std::printf("trees of quality %s: %.0f %% more, %.1f ms\n", quality, 100 * share, medianOf(added));
    expect(share <= mostShare, "trees over dense woods add more to a frame than their share");
  }
  state.SetLabel(with.renderer());
}
BENCHMARK_CAPTURE(trees, low, "low", 0.30)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(trees, high, "high", 0.60)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace skydrop::bench
