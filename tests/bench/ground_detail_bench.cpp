// What the ground close by costs a frame.
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

// Frames of a path over meadow and rock, 8 m up with the nose down, where the detail fills most of the
// picture, with it and without, in turn in one run: the median of their ratios.
void groundDetail(benchmark::State& state, const char* quality, double mostShare) {
  const auto settings = [&](const char* on) {
    return std::vector<std::string>{std::string("quality=") + quality,
                                    std::string("effects.groundDetail=") + on, "view.hud=false"};
  };
  BenchGame with({.scene = "terrain", .set = settings("true")});
  BenchGame without({.scene = "terrain", .set = settings("false")});
  app::Pose pose;
  pose.yawDegrees = 230;
  pose.pitchDegrees = -8;
  for (auto _ : state) {
    std::vector<double> shares, added;
    for (int round = 0; round < kRounds; ++round) {
      const glm::dvec2 at(4420 - 100.0 * round, -530 - 150.0 * round);
      pose.position = {at.x, with.ground().height(at) + 8, at.y};
      for (BenchGame* game : {&with, &without}) game->settle(pose), game->draw(pose);
      std::vector<double> on, off;
      for (int i = 0; i < 7; ++i) off.push_back(without.draw(pose)), on.push_back(with.draw(pose));
      shares.push_back(medianOf(on) / medianOf(off) - 1);
      added.push_back(medianOf(on) - medianOf(off));
    }
    const double share = medianOf(shares);
    state.counters["added"] = share;
    state.counters["addedMs"] = medianOf(added);
    std::printf("ground detail of quality %s: %.0f %% more, %.1f ms\n", quality, 100 * share,
                medianOf(added));
    expect(share <= mostShare, "the ground's detail adds more to a frame than its share");
  }
  state.SetLabel(with.renderer());
}
BENCHMARK_CAPTURE(groundDetail, low, "low", 0.30)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(groundDetail, high, "high", 0.30)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace skydrop::bench
