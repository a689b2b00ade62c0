// What the effects of low flight cost a frame: trees, the ground close by, water close by.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "bench/bench_game.h"
#include "bench/expectation.h"

namespace skydrop::bench {
namespace {

double medianOf(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
  return values[values.size() / 2];
}

// Places that an effect is seen from.
struct Path {
  const char* effect;
  const char* name;  // in what is printed
  const char* scene;
  int places, frames;  // frames: at each place, with the effect and without
  app::Pose (*pose)(const BenchGame& game, int place);
  const char* promise;  // what is printed where it is not kept
};

app::Pose overLand(const BenchGame& game, glm::dvec2 xz, double above, double yaw, double pitch) {
  app::Pose pose;
  pose.position = {xz.x, game.ground().height(xz) + above, xz.y};
  pose.yawDegrees = yaw;
  pose.pitchDegrees = pitch;
  return pose;
}

// 50 m over dense woods.
const Path kTrees = {"vegetation",
                     "trees",
                     "woodland",
                     12,
                     5,
                     [](const BenchGame& game, int i) {
                       return overLand(game, {-1600 - 40.0 * i, -3300 + 30.0 * i}, 50, 200, -12);
                     },
                     "trees over dense woods add more to a frame than their share"};
// 8 m over meadow and rock with the nose down, where the detail fills most of the picture.
const Path kGround = {"groundDetail",
                      "ground detail",
                      "terrain",
                      12,
                      7,
                      [](const BenchGame& game, int i) {
                        return overLand(game, {4420 - 100.0 * i, -530 - 150.0 * i}, 8, 230, -8);
                      },
                      "the ground's detail adds more to a frame than its share"};
// 20 m over a lagoon along its shore, about half of each picture water.
const Path kWater = {"waterDetail",
                     "water",
                     "lagoon",
                     8,
                     5,
                     [](const BenchGame&, int i) {
                       app::Pose pose;
                       pose.position = {3930 - 12.0 * i, 20, 6560 + 8.0 * i};
                       pose.yawDegrees = 75 + 6 * i;
                       pose.pitchDegrees = -4;
                       return pose;
                     },
                     "water close by adds more to a frame than its share"};

// With the effect and without, in turn in one run: the median of the ratios. Each also changes the passes of
// land and sea, so whole frames count.
void added(benchmark::State& state, const Path& path, const char* quality, double mostShare) {
  const auto settings = [&](const char* on) {
    return std::vector<std::string>{std::string("quality=") + quality,
                                    "effects." + std::string(path.effect) + "=" + on, "view.hud=false"};
  };
  BenchGame with({.scene = path.scene, .set = settings("true")});
  BenchGame without({.scene = path.scene, .set = settings("false")});
  for (auto _ : state) {
    std::vector<double> shares, addedMs;
    for (int place = 0; place < path.places; ++place) {
      const app::Pose pose = path.pose(with, place);
      for (BenchGame* game : {&with, &without}) game->settle(pose), game->draw(pose);
      std::vector<double> on, off;
      for (int i = 0; i < path.frames; ++i) off.push_back(without.draw(pose)), on.push_back(with.draw(pose));
      shares.push_back(medianOf(on) / medianOf(off) - 1);
      addedMs.push_back(medianOf(on) - medianOf(off));
    }
    const double share = medianOf(shares);
    state.counters["added"] = share;
    state.counters["addedMs"] = medianOf(addedMs);
    std::printf("%s of quality %s: %.0f %% more, %.1f ms\n", path.name, quality, 100 * share,
                medianOf(addedMs));
    expect(share <= mostShare, path.promise);
  }
  state.SetLabel(with.renderer());
}

void trees(benchmark::State& state, const char* quality, double most) { added(state, kTrees, quality, most); }
void groundDetail(benchmark::State& state, const char* quality, double most) {
  added(state, kGround, quality, most);
}
void water(benchmark::State& state, const char* quality, double most) { added(state, kWater, quality, most); }

BENCHMARK_CAPTURE(trees, low, "low", 0.30)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(trees, high, "high", 0.60)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(groundDetail, low, "low", 0.30)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(groundDetail, high, "high", 0.30)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(water, low, "low", 0.08)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(water, high, "high", 0.15)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace skydrop::bench
