// What clouds cost and how exact they are, tier by tier, against the plain march of the thesis (time) and the
// tier reference (error); what they hold on the GPU; what a clear sky costs.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstdio>

#include "app/measure/frame_times.h"
#include "bench/bench_game.h"
#include "bench/cloud_study.h"
#include "bench/expectation.h"

namespace skydrop::bench {
namespace {

using clouds::CloudTier;

constexpr app::Size kStudySize{800, 600};
constexpr int kRounds = 2;

struct TierPromise {
  CloudTier tier;
  double times;  // as fast as the plain march; 0: no promise
  double error;  // relative, at most; 0: no promise
};

constexpr TierPromise kPromises[] = {{CloudTier::low, 60, 0.08},
                                     {CloudTier::medium, 25, 0.03},
                                     {CloudTier::high, 16, 0.02},
                                     {CloudTier::ultra, 0, 0}};

const char* nameOf(CloudTier tier) { return clouds::kCloudTierNames[static_cast<std::size_t>(tier)].data(); }

void printRow(const CloudView& view, const char* tier, const Cost& cost, const Cost& plain, double error) {
  std::printf("%-8s %-9s %9.1f %9.1f %7.1f %7.1f %8.4f\n", view.name, tier, cost.processorMs, cost.wallMs,
              plain.processorMs / cost.processorMs, plain.wallMs / cost.wallMs, error);
  std::fflush(stdout);
}

void checkPromise(const TierPromise& promise, const CloudView& view, double times, double error) {
  const std::string who = std::string("clouds of the tier ") + nameOf(promise.tier) + " from " + view.name;
  if (promise.times > 0) {
    const std::string text = who + " take more than 1/" + std::to_string(std::lround(promise.times)) +
                             " of the plain march's time";
    expect(times >= promise.times, text.c_str());
  }
  if (promise.error > 0) {
    const std::string text = who + " are off by more than " + std::to_string(promise.error).substr(0, 4);
    expect(error <= promise.error, text.c_str());
  }
}

struct TierRow {
  Cost whole,
      later;  // with every update that a frame may need, the light grids filled again; the frame after it
  double error = 0;
};

// The plain march and the tiers take turns.
void tiersOfClouds(benchmark::State& state) {
  CloudStudy study(kStudySize);
  const CloudView& from = kCloudViews[static_cast<std::size_t>(state.range(0))];
  for (auto _ : state) {
    study.use(settingsOf(CloudTier::reference));
    const Cost ofReference = study.draw(from);
    const CloudPicture reference = study.picture();
    study.use(settingsOf(CloudTier::low));  // what the plain march's frames draw besides
    std::array<TierRow, std::size(kPromises)> rows;
    Cost plain;
    for (int round = 0; round < kRounds; ++round) {
      plain = best(plain, study.drawPlain(from));
      for (std::size_t i = 0; i < rows.size(); ++i) {
        study.use(settingsOf(kPromises[i].tier));
        study.draw(from);  // makes the textures of its size
        study.forgetLight();
        rows[i].whole = best(rows[i].whole, study.draw(from));
        rows[i].later = best(rows[i].later, study.draw(from));
        rows[i].error = relativeError(study.picture().radiance, reference);
      }
    }
    std::printf("%-8s %-9s %9s %9s %7s %7s %8s\n", "view", "tier", "ms", "wall ms", "times", "by wall",
                "error");
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const TierPromise& promise = kPromises[i];
      const double times = plain.processorMs / rows[i].whole.processorMs;
      printRow(from, nameOf(promise.tier), rows[i].whole, plain, rows[i].error);
      printRow(from, "  later", rows[i].later, plain, rows[i].error);
      checkPromise(promise, from, times, rows[i].error);
      state.counters[std::string(nameOf(promise.tier)) + "Times"] = times;
      state.counters[std::string(nameOf(promise.tier)) + "Error"] = rows[i].error;
    }
    printRow(from, "plain", plain, plain, relativeError(study.plainRadiance(), reference));
    printRow(from, "reference", ofReference, plain, 0);
  }
  state.SetLabel(std::string(from.name) + ", " + study.renderer());
}
BENCHMARK(tiersOfClouds)->DenseRange(0, 3)->Iterations(1)->Unit(benchmark::kSecond)->UseRealTime();

void memoryOfClouds(benchmark::State& state) {
  constexpr double kMiB = 1024 * 1024;
  for (auto _ : state) {
    CloudStudy study({1920, 1080});
    study.use(settingsOf(CloudTier::high));
    study.draw(kCloudViews[0]);
    const double mib = static_cast<double>(study.cloudBytes()) / kMiB;
    state.counters["MiB"] = mib;
    expect(mib < 64, "clouds of the tier high hold 64 MiB or more at 1920 x 1080");
  }
}
BENCHMARK(memoryOfClouds)->Iterations(1)->Unit(benchmark::kSecond)->UseRealTime();

// Frames of two games take turns: the scene clear as it is, and without the effect.
void clearSky(benchmark::State& state) {
  constexpr int kFrames = 150;
  BenchGame with({.scene = "clear"}), without({.scene = "clear", .without = scene::Effect::clouds});
  app::Pose pose;
  pose.position = {0, with.ground().height({0, 0}) + 300, 0};
  with.settle(pose);
  without.settle(pose);
  for (auto _ : state) {
    app::FrameTimes withMs, withoutMs;
    for (int frame = 0; frame < kFrames; ++frame) {
      withMs.add(with.draw(pose));
      withoutMs.add(without.draw(pose));
    }
    const double ratio = withMs.quantile(0.5) / withoutMs.quantile(0.5);
    state.counters["withMs"] = withMs.quantile(0.5);
    state.counters["withoutMs"] = withoutMs.quantile(0.5);
    state.counters["ratio"] = ratio;
    expect(ratio <= 1.2, "a clear sky takes more than 1.2 times the frame without the effect clouds");
  }
  state.SetLabel(with.renderer());
}
BENCHMARK(clearSky)->Iterations(1)->Unit(benchmark::kSecond)->UseRealTime();

}  // namespace
}  // namespace skydrop::bench
