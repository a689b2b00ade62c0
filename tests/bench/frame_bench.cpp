// Frames of the whole game at 640 x 360: how even they are in fast flight, and what each pass costs. Left
// out: the window (swap, vsync), sound, the simulation's steps.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <vector>

#include "app/measure/frame_times.h"
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

  void advance(double seconds, double speedMps) {
    if (speedMps == 0) return;
    pose_.position.x += speedMps * seconds;
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

// Frame times in units of the median of their own block of frames, so that what differs between two places
// does not count.
class EvenTimes {
 public:
  void add(const app::FrameTimes& block, const std::vector<double>& ms) {
    const double median = block.quantile(0.5);
    for (const double time : ms) relative_.add(time / median);
    ms_.add(median);
  }
  double medianMs() const { return ms_.quantile(0.5); }
  double p99() const { return relative_.quantile(0.99); }

 private:
  app::FrameTimes relative_, ms_;
};

// Standing and flying take turns, so that what else the machine does falls on both.
void evenFramesInFastFlight(benchmark::State& state) {
  constexpr int kRounds = 10, kFrames = 75;
  for (auto _ : state) {
    BenchGame game({});
    LowFlight flight(game.ground());
    EvenTimes still, flying;
    const auto block = [&](EvenTimes& times, double speedMps) {
      app::FrameTimes ofBlock;
      std::vector<double> ms;
      for (int frame = 0; frame < kFrames; ++frame) {
        ms.push_back(game.draw(flight.pose()));
        ofBlock.add(ms.back());
        flight.advance(ms.back() / 1000, speedMps);
      }
      times.add(ofBlock, ms);
    };
    for (int round = 0; round < kRounds; ++round) {
      game.settle(flight.pose());
      block(still, 0);
      block(flying, kSpeedMps);
    }
    state.counters["stillMs"] = still.medianMs();
    state.counters["stillP99"] = still.p99();
    state.counters["flyingMs"] = flying.medianMs();
    state.counters["flyingP99"] = flying.p99();
    state.counters["ratio"] = flying.p99() / still.p99();
    state.SetLabel(game.renderer());
    expect(flying.p99() <= 1.25 * still.p99(),
           "p99 over median in flight is more than 1.25 times that at rest");
  }
}
BENCHMARK(evenFramesInFastFlight)->Iterations(1)->Unit(benchmark::kSecond);

// What each pass costs in flight: timer queries on hardware; on a software renderer wall clock between
// glFinish calls, which makes the frame as a whole slower.
void passesInFlight(benchmark::State& state) {
  BenchGame game({.measuring = true});
  LowFlight flight(game.ground());
  game.settle(flight.pose());
  game.sceneRenderer().renderer().clearTimes();
  for (auto _ : state) {
    game.draw(flight.pose());
    flight.advance(1.0 / 60, kSpeedMps);
  }
  core::FrameStatistics statistics;
  game.sceneRenderer().writeTo(statistics);
  for (const auto& [pass, row] : statistics.passes) state.counters[pass] = row.ms;
  state.SetLabel(statistics.renderer + ", ms by " + statistics.clock);
}
BENCHMARK(passesInFlight)->Iterations(200)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace skydrop::bench
