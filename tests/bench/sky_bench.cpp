// What the sky's model and the shadows of mountains cost: the shell by tables against the closed form, frames
// of the whole game at 640 x 360.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <string>
#include <string_view>
#include <vector>

#include "app/measure/frame_times.h"
#include "app/settings/settings.h"
#include "bench/bench_game.h"
#include "bench/expectation.h"
#include "bench/repeated_flight.h"
#include "skydrop/core/cpu_clock.h"
#include "skydrop/core/quantile.h"

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

// Processor time of a frame, of all threads of the process: other programs disturb it less than the wall
// clock.
double processorMs(BenchGame& game, const app::Pose& pose, double* wallMs = nullptr) {
  const std::clock_t begin = std::clock();
  const double wall = game.draw(pose);
  if (wallMs) *wallMs = wall;
  return 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

// Settled frames with either model, in turns: the whole frame, so tables, sky, haze and all that asks for
// light. Ratios are of processor time; those by the wall clock are shown beside them.
void shellAgainstClosedForm(benchmark::State& state) {
  constexpr int kRounds = 12, kFrames = 8;
  for (auto _ : state) {
    BenchGame shell(setupOf("terrain", "shell")), closed(setupOf("terrain", "closedForm"));
    for (const Place& place : kPlaces) {
      shell.settle(place.pose);
      closed.settle(place.pose);
      std::vector<double> ratios, walls;
      app::FrameTimes shellMs, closedMs;
      for (int round = 0; round < kRounds; ++round) {
        app::FrameTimes a, b, aWall, bWall;
        for (int frame = 0; frame < kFrames; ++frame) {
          double wall = 0;
          a.add(processorMs(shell, place.pose, &wall)), aWall.add(wall);
          b.add(processorMs(closed, place.pose, &wall)), bWall.add(wall);
        }
        ratios.push_back(a.quantile(0.5) / b.quantile(0.5));
        walls.push_back(aWall.quantile(0.5) / bWall.quantile(0.5));
        shellMs.add(a.quantile(0.5));
        closedMs.add(b.quantile(0.5));
      }
      std::ranges::sort(ratios);
      std::ranges::sort(walls);
      const std::string name(place.name);
      state.counters[name + "Ratio"] = ratios[ratios.size() / 2];
      state.counters[name + "WallRatio"] = walls[walls.size() / 2];
      state.counters[name + "ShellMs"] = shellMs.quantile(0.5);
      state.counters[name + "ClosedMs"] = closedMs.quantile(0.5);
      expect(ratios[ratios.size() / 2] <= 1.1,
             "a settled frame takes at most 1.1 times as long with the shell");
    }
  }
}
BENCHMARK(shellAgainstClosedForm)->Unit(benchmark::kMillisecond)->Iterations(1);

// A loop of arithmetic of about 1 ms that always does the same: what it takes longer is the
// machine's.
double controlMs() {
  const core::CpuClock cpu;
  double x = 1;
  for (int i = 0; i < 150000; ++i) x = std::sqrt(x * 1.7 + static_cast<double>(i));
  benchmark::DoNotOptimize(x);
  return cpu.ms();
}

// What a change adds to the frames after it, by the CPU time of the thread that draws: a game that changes
// and one at rest draw in turns. The changes are a function of the period and the frame in it alone, and the
// whole is flown kFlights times, so each frame does the same work in each flight. Promised is the worst of
// the frames' medians over the flights; how often single frames exceed theirs by kMostMs stands beside how
// often the frame at rest and a loop of arithmetic do.
class AddedTimes {
 public:
  static constexpr int kPeriod = 12, kPeriods = 40, kFlights = 7;
  static constexpr double kMostMs = 8;

  // change(period, frame, pose) is called before each frame; period -1 is what each flight begins from.
  template <class Change>
  void measure(BenchGame& still, BenchGame& moving, const app::Pose& pose, const Change& change) {
    const auto cpuMs = [](BenchGame& game, const app::Pose& at) {
      const core::CpuClock cpu;
      game.draw(at);
      return cpu.ms();
    };
    for (int flight = 0; flight < kFlights; ++flight) {
      app::Pose from = pose;
      change(-1, 0, from);
      moving.settle(from);
      if (flight == 0) still.settle(pose);
      for (BenchGame* game : {&still, &moving}) game->sceneRenderer().setFramesFollow(true);
      still.draw(pose), moving.draw(from);
      for (std::size_t i = 0; i < moving_.frames(); ++i) {
        app::Pose at = pose;
        change(static_cast<int>(i) / kPeriod, static_cast<int>(i) % kPeriod, at);
        moving_.add(i, cpuMs(moving, at));
        still_.add(i, cpuMs(still, pose));
        control_.add(i, controlMs());
      }
    }
  }

  void report(benchmark::State& state, const char* promise) {
    std::array<std::vector<double>, kPeriod> ofFrames;  // by frame of the period
    std::vector<double> added;
    for (std::size_t i = 0; i < moving_.frames(); ++i) {
      added.push_back(moving_.medianOf(i) - still_.medianOf(i));
      ofFrames[i % kPeriod].push_back(added.back());
    }
    for (std::size_t frame = 0; frame < kPeriod; ++frame) {
      const std::vector<double>& ms = ofFrames[frame];
      std::printf("  frame %2zu: %5.1f ms more in the middle of %d periods, %5.1f at worst\n", frame,
                  core::quantileOf(ms, 0.5), kPeriods, core::quantileOf(ms, 1));
    }
    state.counters["addedMs"] = core::quantileOf(added, 0.5);
    state.counters["addedMsOfNineInTen"] = core::quantileOf(added, 0.9);
    state.counters["addedMsWorst"] = core::quantileOf(added, 1);
    state.counters["longFrames"] = moving_.shareOfLong(kMostMs);
    state.counters["longFramesAtRest"] = still_.shareOfLong(kMostMs);
    state.counters["longLoops"] = control_.shareOfLong(kMostMs);
    state.counters["loopMs"] = core::quantileOf(control_.medians(), 0.5);
    expect(core::quantileOf(added, 1) < kMostMs, promise);
  }

 private:
  // CPU ms of the frame that changes, of the one at rest, and of the loop.
  RepeatedFlight moving_{kPeriod * kPeriods}, still_{kPeriod * kPeriods}, control_{kPeriod * kPeriods};
};

// The eye climbs at 60 m/s and the sun sets at half a degree a second.
void rebuiltTables(benchmark::State& state) {
  for (auto _ : state) {
    const BenchGame::Setup setup{.scene = "terrain", .set = {"quality=low", "render.sun.elevationDegrees=4"}};
    BenchGame still(setup), moving(setup);
    AddedTimes times;
    times.measure(still, moving, kPlaces[1].pose, [&](int period, int frame, app::Pose& pose) {
      const double frames = period < 0 ? 0 : 1 + period * AddedTimes::kPeriod + frame;
      pose.position.y += frames;
      moving.set("render.sun.elevationDegrees=" + std::to_string(4 - frames * 0.5 / 60));
    });
    times.report(state, "tables are rebuilt within 8 ms of added frame time");
  }
}
BENCHMARK(rebuiltTables)->Unit(benchmark::kMillisecond)->Iterations(1);

// The sun jumps by many degrees, so that none of the tables that it needs are there.
void jumpingSun(benchmark::State& state) {
  for (auto _ : state) {
    const BenchGame::Setup setup{.scene = "terrain",
                                 .set = {"quality=low", "render.sun.elevationDegrees=30"}};
    BenchGame still(setup), moving(setup);
    AddedTimes times;
    times.measure(still, moving, kPlaces[1].pose, [&](int period, int frame, app::Pose&) {
      if (frame > 0) return;
      const double elevation = period < 0 ? 30 : -9 + 0.9 * ((period * 37) % AddedTimes::kPeriods);
      moving.set("render.sun.elevationDegrees=" + std::to_string(elevation));
    });
    times.report(state, "a sun that jumps is followed within 8 ms of added frame time");
  }
}
BENCHMARK(jumpingSun)->Unit(benchmark::kMillisecond)->Iterations(1);

// Haze that changes, as while its slider is dragged.
void newAir(benchmark::State& state) {
  for (auto _ : state) {
    const BenchGame::Setup setup{.scene = "terrain", .set = {"quality=low", "render.sun.elevationDegrees=8"}};
    BenchGame still(setup), changing(setup);
    AddedTimes times;
    times.measure(still, changing, kPlaces[1].pose, [&](int period, int frame, app::Pose&) {
      if (frame == 0) changing.set("render.atmosphere.visibilityM=" + std::to_string(40000 + 1000 * period));
    });
    times.report(state, "a new air is made within 8 ms of added frame time");
  }
}
BENCHMARK(newAir)->Unit(benchmark::kMillisecond)->Iterations(1);

double passMs(BenchGame& game, std::string_view pass) {
  for (const auto& [name, ms] : game.sceneRenderer().renderer().newestTimes()) {
    if (name == pass) return ms;
  }
  return 0;
}

// What a pass takes with the effect landShadows against without, in turns. By processor time: what frames
// take more, against the share of it that the pass has of the wall clock in frames without.
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
      app::FrameTimes withMs, withoutMs, passShare;
      for (int frame = 0; frame < kFrames; ++frame) {
        double wall = 0;
        withMs.add(processorMs(with, pose));
        withoutMs.add(processorMs(without, pose, &wall));
        passShare.add(passMs(without, pass) / wall);
      }
      const double ofPass = passShare.quantile(0.5) * withoutMs.quantile(0.5);
      ratios.push_back(1 + (withMs.quantile(0.5) - withoutMs.quantile(0.5)) / ofPass);
      a.add(withMs.quantile(0.5)), b.add(withoutMs.quantile(0.5));
    }
    std::ranges::sort(ratios);
    state.counters["ratio"] = ratios[ratios.size() / 2];
    state.counters["ratioLow"] = ratios[ratios.size() / 4];
    state.counters["ratioHigh"] = ratios[ratios.size() * 3 / 4];
    state.counters["frameWithMs"] = a.quantile(0.5);
    state.counters["frameWithoutMs"] = b.quantile(0.5);
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
