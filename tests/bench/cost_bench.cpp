// What the bill of the effects leaves out, and how soon a scene without effects is there.
#include <benchmark/benchmark.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "app/measure/bill.h"
#include "app/studies/scene_bill.h"
#include "bench/expectation.h"
#include "skydrop/core/quantile.h"
#include "skydrop/scene/scene.h"
#include "support/paths.h"
#include "support/shared_noise.h"
#include "support/temporary_folder.h"

namespace skydrop::bench {
namespace {

// The rows of the bill, passes and updates and two steps, make up nearly all of the frame (640 x 360, quality
// low).
void billCoversTheFrame(benchmark::State& state) {
  setenv("XDG_CACHE_HOME", test::sharedCacheHome().c_str(), 1);
  test::sharedNoise();
  for (auto _ : state) {
    for (const std::string& scene : scene::listScenes()) {
      app::MeasuredGame game({scene, {640, 360}, {"quality=low"}});
      const app::SceneBill bill = app::billOf(game, 30);
      const double share = bill.paidShare();
      state.counters[scene] = share;
      if (share < 0.95) {
        const double frameMs = core::quantileOf(bill.frameMs, 0.5);
        std::fprintf(stderr, "%s: %.3f ms of %.3f ms are in no row\n", scene.c_str(), (1 - share) * frameMs,
                     frameMs);
      }
      expect(share >= 0.95, "the bill of a scene covers less than 95 % of its frame");
    }
  }
}
BENCHMARK(billCoversTheFrame)->Iterations(1)->Unit(benchmark::kSecond);

// From the start of the program to the first frame on disk, empty and fair in turns, all caches warm.
void emptyStartsInHalfTheTime(benchmark::State& state) {
  const test::TemporaryFolder folder;
  const auto seconds = [&](const std::string& scene) {
    const std::string command = "XDG_CACHE_HOME='" + test::sharedCacheHome().string() + "' '" +
                                test::programFile() + "' render --scene " + scene +
                                " --size 320x180 --out '" + (folder.path() / "frame.png").string() +
                                "' > /dev/null";
    const auto begin = std::chrono::steady_clock::now();
    expect(std::system(command.c_str()) == 0, "the program failed");
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  test::sharedNoise();
  for (auto _ : state) {
    std::vector<double> empty, fair, ratios;
    for (const char* scene : {"empty", "fair"}) seconds(scene);
    for (int round = 0; round < 5; ++round) {
      empty.push_back(seconds("empty"));
      fair.push_back(seconds("fair"));
      ratios.push_back(empty.back() / fair.back());
    }
    state.counters["emptyS"] = core::quantileOf(empty, 0.5);
    state.counters["fairS"] = core::quantileOf(fair, 0.5);
    state.counters["ratio"] = core::quantileOf(ratios, 0.5);
    expect(core::quantileOf(ratios, 0.5) <= 0.5,
           "the first frame of the scene empty takes more than half the time of that of fair");
  }
}
BENCHMARK(emptyStartsInHalfTheTime)->Iterations(1)->Unit(benchmark::kSecond);

}  // namespace
}  // namespace skydrop::bench
