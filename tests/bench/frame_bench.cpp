// Frames of the whole game at 640 x 360: how even they are in fast flight, and what each pass costs. Left
// out: the window (swap, vsync), sound, the simulation's steps.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <string>
#include <vector>

#include "app/frame_times.h"
#include "bench/bench_game.h"
#include "bench/expectation.h"

namespace skydrop::bench {
namespace {

constexpr double kSpeedMps = 300;

// A flight along +x that keeps 150 m above what lies ahead.
class LowFlight {
 public:
  explicit LowFlight(const terrain::HeightSource& ground) : ground_(ground) {
    pose_.position = {0, wanted(), 0};
  }

  const app::Pose& pose() const { return pose_; }

  void advance(double seconds) {
    pose_.position.x += kSpeedMps * seconds;
    pose_.position.y += (wanted() - pose_.position.y) * std::min(1.0, seconds);
  }

 private:
  double wanted() const {
    double highest = 0;
    for (int ahead = 0; ahead <= 2000; ahead += 200) {
      highest = std::max(highest, ground_.height({pose_.position.x + ahead, pose_.position.z}));
    }
    return highest + 150;
  }

  const terrain::HeightSource& ground_;
  app::Pose pose_;
};

// Standing and flying take turns, so that what else the machine does falls on both.
void evenFramesInFastFlight(benchmark::State& state) {
  constexpr int kRounds = 8, kFrames = 75;
  for (auto _ : state) {
    BenchGame game;
    LowFlight flight(game.ground());
    app::FrameTimes still, flying;
    for (int round = 0; round < kRounds; ++round) {
      game.settle(flight.pose());
      for (int frame = 0; frame < kFrames; ++frame) still.add(game.draw(flight.pose()));
      double ms = still.quantile(0.5);
      for (int frame = 0; frame < kFrames; ++frame) {
        flight.advance(ms / 1000);
        flying.add(ms = game.draw(flight.pose()));
      }
    }
    const double unevenStill = still.quantile(0.99) / still.quantile(0.5);
    const double unevenFlying = flying.quantile(0.99) / flying.quantile(0.5);
    state.counters["stillMs"] = still.quantile(0.5);
    state.counters["stillP99"] = unevenStill;
    state.counters["flyingMs"] = flying.quantile(0.5);
    state.counters["flyingP99"] = unevenFlying;
    state.counters["flyingToStill"] = unevenFlying / unevenStill;
    state.SetLabel(game.renderer());
    expect(state, unevenFlying <= 1.25 * unevenStill,
           "p99 over median in flight is more than 1.25 times that at rest");
  }
}
BENCHMARK(evenFramesInFastFlight)->Iterations(1)->Unit(benchmark::kSecond);

}  // namespace
}  // namespace skydrop::bench
