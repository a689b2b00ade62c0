// What rain costs a frame of quality low.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <string>
#include <vector>

#include "bench/bench_game.h"
#include "bench/expectation.h"

namespace skydrop::bench {
namespace {

constexpr int kFrames = 60;
constexpr const char* kPasses[] = {"rainMap", "wetGround", "rainVeil", "precipitation", "splashes"};

// All passes of the effect in a thunderstorm's rain of 18 mm/h, from 400 m: the median of each, and their
// sum. In one run, so that the machine is the same; wet land is part of the pass of the land, and no slower
// than dry land by more than runs differ.
void rainOfQualityLow(benchmark::State& state) {
  BenchGame game({.measuring = true,
                  .scene = "thunderstorm",
                  .set = {"quality=low", "weather.sites.0.layers.0.cover=0.97"}});
  app::Pose pose;
  pose.position = {0, 400, 0};
  pose.yawDegrees = 40;
  game.settle(pose);
  for (auto _ : state) {
    for (int frame = 0; frame < kFrames; ++frame) game.draw(pose);
    core::FrameStatistics statistics;
    game.sceneRenderer().writeTo(statistics, kFrames);
    double all = 0;
    for (const auto& [name, row] : statistics.passes) {
      for (const char* pass : kPasses) {
        if (name != pass) continue;
        std::printf("%s %.2f ms%s\n", pass, row.ms, row.skipped.empty() ? "" : " (skipped)");
        state.counters[pass] = row.ms;
        all += row.ms;
      }
    }
    state.counters["allMs"] = all;
    expect(all > 0, "no rain was drawn");
    expect(all <= 2, "rain takes more than 2 ms of a frame of quality low");
  }
  state.SetLabel(game.renderer());
}
BENCHMARK(rainOfQualityLow)->Iterations(1)->Unit(benchmark::kSecond)->UseRealTime();

}  // namespace
}  // namespace skydrop::bench
