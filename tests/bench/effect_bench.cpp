// Effects that come and go while flying hold no frame up.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "app/measure/frame_times.h"
#include "bench/bench_game.h"
#include "bench/expectation.h"
#include "support/temporary_folder.h"

namespace skydrop::bench {
namespace {

constexpr app::Pose kAbove{{0, 500, 0}, 0, -5, 0};

// Each effect that is drawn goes and comes, with a driver's cache that is empty at first: its first coming
// compiles all that it needs. The longest frame from when it is switched to when it is drawn, in units of the
// median at rest; beside it the longest at rest, which shows what else the machine does.
void switchingEffects(benchmark::State& state) {
  constexpr int kFrames = 20;
  const test::TemporaryFolder cache;
  setenv("MESA_SHADER_CACHE_DIR", cache.path().c_str(), 1);
  for (auto _ : state) {
    double worst = 0;
    std::string slowest;
    BenchGame game({.scene = "fair", .set = {"quality=low"}});
    game.settle(kAbove);
    app::FrameTimes still;
    const auto rest = [&] {
      for (int frame = 0; frame < kFrames; ++frame) still.add(game.draw(kAbove));
    };
    const scene::EffectSet all = game.effects();
    scene::EffectSet more = all;
    for (const auto effect : {scene::Effect::cloudPlanes, scene::Effect::cloudDome, scene::Effect::groundFog})
      more.insert(effect);
    for (std::size_t i = 0; i < scene::kEffectNames.size(); ++i) {
      const auto effect = static_cast<scene::Effect>(i);
      scene::EffectSet with = all, without = all;
      with.insert(effect);
      without.erase(effect);
      if (!more.contains(effect) || !scene::unmetNeed(without).empty()) continue;
      without = scene::effective(without);
      rest();
      double longest = 0;
      for (const scene::EffectSet& next : {without, with, all}) {
        if (next == game.effects()) continue;
        game.switchTo(next);
        while (game.isSwitching()) {
          const double ms = game.continueSwitch(0.5 * still.quantile(0.5)) + game.draw(kAbove);
          longest = std::max(longest, ms / still.quantile(0.5));
        }
      }
      const std::string name(scene::nameOf(effect));
      state.counters[name] = longest;
      if (longest > worst) worst = longest, slowest = name;
    }
    state.counters["medianMs"] = still.quantile(0.5);
    state.counters["longestAtRest"] = still.quantile(1) / still.quantile(0.5);
    state.counters["longest"] = worst;
    state.SetLabel(game.renderer() + ", the longest while switching " + slowest);
    expect(worst <= 3, "a frame in which an effect comes or goes takes more than three times the median");
  }
}
BENCHMARK(switchingEffects)->Iterations(1)->Unit(benchmark::kSecond);

}  // namespace
}  // namespace skydrop::bench
