// Effects that come and go while flying hold no frame up.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>

#include "app/measure/frame_times.h"
#include "bench/bench_game.h"
#include "bench/expectation.h"

namespace skydrop::bench {
namespace {

constexpr app::Pose kAbove{{0, 500, 0}, 0, -5, 0};

// Each effect that is drawn goes and comes, twice: at its first coming everything is compiled. The longest
// frame, in units of the median at rest.
void switchingEffects(benchmark::State& state) {
  constexpr int kFrames = 20;
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
    for (std::size_t i = 0; i < scene::kEffectNames.size(); ++i) {
      const auto effect = static_cast<scene::Effect>(i);
      scene::EffectSet less = all;
      less.erase(effect);
      if (!all.contains(effect) || !scene::unmetNeed(less).empty()) continue;
      less = scene::effective(less);
      for (int round = 0; round < 2; ++round) {
        rest();
        for (const scene::EffectSet& next : {less, all}) {
          game.switchTo(next);
          while (game.isSwitching()) {
            const double ms = game.continueSwitch(0.5 * still.quantile(0.5)) + game.draw(kAbove);
            const double relative = ms / still.quantile(0.5);
            if (relative > worst) worst = relative, slowest = scene::nameOf(effect);
          }
        }
      }
    }
    state.counters["medianMs"] = still.quantile(0.5);
    state.counters["longest"] = worst;
    state.SetLabel(game.renderer() + ", the longest while switching " + slowest);
    expect(worst <= 3, "a frame in which an effect comes or goes takes more than three times the median");
  }
}
BENCHMARK(switchingEffects)->Iterations(1)->Unit(benchmark::kSecond);

}  // namespace
}  // namespace skydrop::bench
