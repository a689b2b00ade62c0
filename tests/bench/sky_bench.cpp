// What the sky's model and the shadows of mountains cost: the shell by tables against the closed form, frames
// of the whole game at 640 x 360.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "app/measure/frame_times.h"
#include "app/settings/settings.h"
#include "bench/bench_game.h"
#include "bench/expectation.h"

namespace skydrop::bench {
namespace {

BenchGame::Setup setupOf(const char* scene, const char* model) {
  return {.scene = scene,
          .set = {"quality=low", "render.sun.elevationDegrees=20", std::string("render.sky.model=") + model}};
}

// Views that the sky fills, half fills, and where it is seen through haze alone.
struct Place {
  const char* name;
  app::Pose pose;
};
const Place kPlaces[] = {{"up", {{0, 1200, 0}, 0, 50, 0}},
                         {"level", {{0, 1200, 0}, 0, 0, 0}},
                         {"down", {{0, 3000, 0}, 0, -35, 0}}};

// Settled frames with either model, in turns: the whole frame, so tables, sky, haze and all that asks for
// light.
void shellAgainstClosedForm(benchmark::State& state) {
  constexpr int kRounds = 12, kFrames = 8;
  for (auto _ : state) {
    BenchGame shell(setupOf("terrain", "shell")), closed(setupOf("terrain", "closedForm"));
    for (const Place& place : kPlaces) {
      shell.settle(place.pose);
      closed.settle(place.pose);
      std::vector<double> ratios;
      app::FrameTimes shellMs, closedMs;
      for (int round = 0; round < kRounds; ++round) {
        app::FrameTimes a, b;
        for (int frame = 0; frame < kFrames; ++frame) {
          a.add(shell.draw(place.pose));
          b.add(closed.draw(place.pose));
        }
        ratios.push_back(a.quantile(0.5) / b.quantile(0.5));
        shellMs.add(a.quantile(0.5));
        closedMs.add(b.quantile(0.5));
      }
      std::ranges::sort(ratios);
      const std::string name(place.name);
      state.counters[name + "Ratio"] = ratios[ratios.size() / 2];
      state.counters[name + "ShellMs"] = shellMs.quantile(0.5);
      state.counters[name + "ClosedMs"] = closedMs.quantile(0.5);
      expect(ratios[ratios.size() / 2] <= 1.1,
             "a settled frame takes at most 1.1 times as long with the shell");
    }
  }
}
BENCHMARK(shellAgainstClosedForm)->Unit(benchmark::kMillisecond)->Iterations(1);

// The eye climbs and the sun sets at 0.5 degrees a second: frames in which tables are rebuilt, against those
// at rest.
void rebuiltTables(benchmark::State& state) {
  constexpr int kFrames = 240;
  for (auto _ : state) {
    BenchGame game(
        {.scene = "terrain",
         .set = {"quality=low", "sky.sun=clock", "sky.utc=2026-06-21T19:00:00Z", "sky.timeScale=120"}});
    app::Pose pose = kPlaces[1].pose;
    game.settle(pose);
    app::FrameTimes still, moving;
    for (int frame = 0; frame < kFrames; ++frame) still.add(game.draw(pose));
    for (int frame = 0; frame < kFrames; ++frame) {
      pose.position.y += 1;
      moving.add(game.draw(pose));
    }
    state.counters["stillMs"] = still.quantile(0.5);
    state.counters["movingMs"] = moving.quantile(0.5);
    state.counters["stillLongestMs"] = still.quantile(0.99);
    state.counters["movingLongestMs"] = moving.quantile(0.99);
    expect(moving.quantile(0.99) - still.quantile(0.99) < 8,
           "tables are rebuilt within 8 ms of added frame time");
  }
}
BENCHMARK(rebuiltTables)->Unit(benchmark::kMillisecond)->Iterations(1);

// Haze that changes every twelfth frame, as while its slider is dragged: frames against those at rest.
void newAir(benchmark::State& state) {
  constexpr int kFrames = 240;
  for (auto _ : state) {
    BenchGame game({.scene = "terrain", .set = {"quality=low", "render.sun.elevationDegrees=8"}});
    const app::Pose pose = kPlaces[1].pose;
    game.settle(pose);
    game.sceneRenderer().setFramesFollow(true);
    app::FrameTimes still, changing;
    for (int frame = 0; frame < kFrames; ++frame) still.add(game.draw(pose));
    for (int frame = 0; frame < kFrames; ++frame) {
      if (frame % 12 == 0) game.set("render.atmosphere.visibilityM=" + std::to_string(40000 + 100 * frame));
      changing.add(game.draw(pose));
    }
    state.counters["stillMs"] = still.quantile(0.5);
    state.counters["changingMs"] = changing.quantile(0.5);
    state.counters["stillLongestMs"] = still.quantile(0.99);
    state.counters["changingLongestMs"] = changing.quantile(0.99);
    expect(changing.quantile(0.99) - still.quantile(0.99) < 8,
           "a new air is made within 8 ms of added frame time");
  }
}
BENCHMARK(newAir)->Unit(benchmark::kMillisecond)->Iterations(1);

double passMs(BenchGame& game, std::string_view pass) {
  for (const auto& [name, ms] : game.sceneRenderer().renderer().newestTimes()) {
    if (name == pass) return ms;
  }
  return 0;
}

// What a pass takes with the effect landShadows against without, in turns.
void withLandShadows(benchmark::State& state, const BenchGame::Setup& setup, const app::Pose& pose,
                     std::string_view pass, double most) {
  constexpr int kRounds = 15, kFrames = 6;
  for (auto _ : state) {
    BenchGame::Setup plain = setup;
    plain.without = scene::Effect::landShadows;
    BenchGame with(setup), without(plain);
    with.settle(pose);
    without.settle(pose);
    std::vector<double> ratios;
    app::FrameTimes a, b;
    for (int round = 0; round < kRounds; ++round) {
      app::FrameTimes withMs, withoutMs;
      for (int frame = 0; frame < kFrames; ++frame) {
        with.draw(pose), withMs.add(passMs(with, pass));
        without.draw(pose), withoutMs.add(passMs(without, pass));
      }
      ratios.push_back(withMs.quantile(0.5) / withoutMs.quantile(0.5));
      a.add(withMs.quantile(0.5)), b.add(withoutMs.quantile(0.5));
    }
    std::ranges::sort(ratios);
    state.counters["ratio"] = ratios[ratios.size() / 2];
    state.counters["ratioLow"] = ratios[ratios.size() / 4];
    state.counters["ratioHigh"] = ratios[ratios.size() * 3 / 4];
    state.counters["withMs"] = a.quantile(0.5);
    state.counters["withoutMs"] = b.quantile(0.5);
    expect(ratios[ratios.size() / 2] <= most,
           "shadows of mountains cost their pass no more than is promised");
  }
}

void mountainShadowsOnLand(benchmark::State& state) {
  withLandShadows(state,
                  {.measuring = true,
                   .scene = "terrain",
                   .set = {"render.sun.elevationDegrees=6", "render.sun.azimuthDegrees=265"}},
                  {{2500, 700, -1200}, -38, 2, 0}, "terrain", 1.15);
}
BENCHMARK(mountainShadowsOnLand)->Unit(benchmark::kMillisecond)->Iterations(1);

void mountainShadowsOnClouds(benchmark::State& state) {
  withLandShadows(state,
                  {.measuring = true,
                   .scene = "shafts",
                   .set = {"render.sun.elevationDegrees=6", "render.sun.azimuthDegrees=60",
                           "clouds.cloudHeight=450", "clouds.thickness=350", "clouds.coverage=1"}},
                  {{8000, 1500, -7500}, 240, -12, 0}, "clouds", 1.15);
}
BENCHMARK(mountainShadowsOnClouds)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
}  // namespace skydrop::bench
