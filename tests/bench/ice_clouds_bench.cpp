// What a layer of ice costs.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <string>
#include <vector>

#include "bench/bench_game.h"
#include "bench/expectation.h"

namespace skydrop::bench {
namespace {

constexpr int kFrames = 60;

// One layer each, by hand, quality low at 640 x 360, up at 20 degrees: its pass, and its shade on the land.
void iceClouds(benchmark::State& state) {
  const char* const genera[] = {"cirrus", "cirrostratus", "cirrocumulus"};
  for (auto _ : state) {
    for (const char* genus : genera) {
      BenchGame game({.measuring = true,
                      .scene = "cirrus",
                      .set = {"quality=low", std::string("iceClouds.genus=") + genus}});
      app::Pose pose;
      pose.position = {0, game.ground().height({0, 0}) + 300, 0};
      pose.yawDegrees = 200;
      pose.pitchDegrees = 20;
      game.settle(pose);
      for (int frame = 0; frame < kFrames; ++frame) game.draw(pose);
      const double ms = game.medianMs("iceClouds", kFrames), shadeMs = game.medianMs("iceShade", kFrames);
      std::printf("%s %.2f ms, its shade %.2f ms\n", genus, ms, shadeMs);
      state.counters[genus] = ms;
      expect(ms > 0, "the pass was not drawn");
      expect(genus != genera[0] || ms + shadeMs <= 1.5, "a layer of cirrus takes more than 1.5 ms");
    }
  }
}
BENCHMARK(iceClouds)->Iterations(1)->Unit(benchmark::kSecond)->UseRealTime();

}  // namespace
}  // namespace skydrop::bench
