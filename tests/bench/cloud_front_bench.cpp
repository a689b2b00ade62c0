// What each parameter of the march buys: the tier high with one of them changed, error against time. Runs
// only by name.
#include <benchmark/benchmark.h>

#include <array>
#include <cstdio>

#include "bench/cloud_study.h"

namespace skydrop::bench {
namespace {

constexpr app::Size kSize{400, 300};
constexpr int kRounds = 3;

using clouds::MarchResolution;
using clouds::MarchSettings;

struct Change {
  const char* name;
  void (*make)(MarchSettings& march);
};

constexpr Change kChanges[] = {
    {"high", [](MarchSettings&) {}},
    {"resolution full", [](MarchSettings& m) { m.resolution = MarchResolution::full; }},
    {"resolution half", [](MarchSettings& m) { m.resolution = MarchResolution::half; }},
    {"tolerances halved", [](MarchSettings& m) { m.coarseTolerance /= 2, m.fineTolerance /= 2; }},
    {"tolerances doubled", [](MarchSettings& m) { m.coarseTolerance *= 2, m.fineTolerance *= 2; }},
    {"stepGrowth 0.00125", [](MarchSettings& m) { m.stepGrowth = 0.00125; }},
    {"stepGrowth 0.005", [](MarchSettings& m) { m.stepGrowth = 0.005; }},
    {"clearStride 0", [](MarchSettings& m) { m.clearStride = 0; }},
    {"clearStride 1.5", [](MarchSettings& m) { m.clearStride = 1.5; }},
    {"lightOpacity 0.005", [](MarchSettings& m) { m.lightOpacity = 0.005; }},
    {"lightOpacity 0.04", [](MarchSettings& m) { m.lightOpacity = 0.04; }},
    {"steps to the sun halved",
     [](MarchSettings& m) { m.sunStepM /= 2, m.sunStepGrowth /= 2, m.sunStepPerDepthM /= 2; }},
    {"steps to the sun doubled",
     [](MarchSettings& m) { m.sunStepM *= 2, m.sunStepGrowth *= 2, m.sunStepPerDepthM *= 2; }},
    {"sunClearStride 0", [](MarchSettings& m) { m.sunClearStride = 0; }},
};

struct FrontRow {
  Cost cost;
  double error = 0;
};

void frontOfTheTiers(benchmark::State& state) {
  CloudStudy study(kSize);
  state.SetLabel(study.renderer());
  for (auto _ : state) {
    for (const std::size_t view : {0, 3}) {
      const CloudView& from = kCloudViews[view];
      study.use(settingsOf(clouds::CloudTier::reference));
      study.draw(from);
      const CloudPicture reference = study.picture();
      std::array<FrontRow, std::size(kChanges)> rows;
      Cost plain;
      for (int round = 0; round < kRounds; ++round) {
        for (std::size_t i = 0; i < rows.size(); ++i) {
          clouds::CloudSettings settings = settingsOf(clouds::CloudTier::high);
          kChanges[i].make(settings.march);
          study.use(settings);
          plain = best(plain, study.drawPlain(from));
          for (int again = 0; again < 2; ++again) rows[i].cost = best(rows[i].cost, study.draw(from));
          rows[i].error = relativeError(study.picture().radiance, reference);
        }
      }
      std::printf("%-8s %-26s %9s %7s %7s\n", "view", "high with", "ms", "times", "error");
      for (std::size_t i = 0; i < rows.size(); ++i) {
        std::printf("%-8s %-26s %9.1f %7.1f %7.4f\n", from.name, kChanges[i].name, rows[i].cost.processorMs,
                    plain.processorMs / rows[i].cost.processorMs, rows[i].error);
      }
      std::fflush(stdout);
    }
  }
}
BENCHMARK(frontOfTheTiers)
    ->Name("frontOfTheTiers/byName")
    ->Iterations(1)
    ->Unit(benchmark::kSecond)
    ->UseRealTime();

}  // namespace
}  // namespace skydrop::bench
