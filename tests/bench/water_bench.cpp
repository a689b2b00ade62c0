// What water close by costs a frame.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "bench/bench_game.h"
#include "bench/expectation.h"

namespace skydrop::bench {
namespace {

constexpr int kRounds = 8;

double medianOf(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
  return values[values.size() / 2];
}

// Frames of a path along a lagoon's shore, 20 m up, about half of each water, with the effect and without, in
// turn in one run: the median of their ratios. The effect changes the passes of land and sea, so whole frames
// count.
void water(benchmark::State& state, const char* quality, double mostShare) {
  const auto settings = [&](const char* on) {
    return std::vector<std::string>{std::string("quality=") + quality,
                                    std::string("effects.waterDetail=") + on, "view.hud=false"};
  };
  BenchGame with({.scene = "lagoon", .set = settings("true")});
  BenchGame without({.scene = "lagoon", .set = settings("false")});
  app::Pose pose;
  pose.pitchDegrees = -4;
  for (auto _ : state) {
    std::vector<double> shares, added;
    for (int round = 0; round < kRounds; ++round) {
      pose.position = {3930 - 12.0 * round, 20, 6560 + 8.0 * round};
      pose.yawDegrees = 75 + 6 * round;
      for (BenchGame* game : {&with, &without}) game->settle(pose), game->draw(pose);
      std::vector<double> on, off;
      for (int i = 0; i < 5; ++i) off.push_back(without.draw(pose)), on.push_back(with.draw(pose));
      shares.push_back(medianOf(on) / medianOf(off) - 1);
      added.push_back(medianOf(on) - medianOf(off));
    }
    const double share = medianOf(shares);
    state.counters["added"] = share;
    state.counters["addedMs"] = medianOf(added);
    std::printf("water of quality %s: %.0f %% more, %.1f ms\n", quality, 100 * share, medianOf(added));
    expect(share <= mostShare, "water close by adds more to a frame than its share");
  }
  state.SetLabel(with.renderer());
}
BENCHMARK_CAPTURE(water, low, "low", 0.08)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(water, high, "high", 0.15)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace skydrop::bench
