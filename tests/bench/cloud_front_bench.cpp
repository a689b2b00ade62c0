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
    {"stepGrowth 0.003", [](MarchSettings& m) { m.stepGrowth = 0.003; }},
    {"stepGrowth 0.006", [](MarchSettings& m) { m.stepGrowth = 0.006; }},
    {"stepGrowth 0.012", [](MarchSettings& m) { m.stepGrowth = 0.012; }},
    {"sunSamples 4", [](MarchSettings& m) { m.sunSamples = 4; }},
    {"sunSamples 8", [](MarchSettings& m) { m.sunSamples = 8; }},
    {"sunSamples 16", [](MarchSettings& m) { m.sunSamples = 16; }},
    {"sunSamples 32", [](MarchSettings& m) { m.sunSamples = 32; }},
    {"maxSegmentOpticalDepth 0.35", [](MarchSettings& m) { m.maxSegmentOpticalDepth = 0.35; }},
    {"maxSegmentOpticalDepth 2", [](MarchSettings& m) { m.maxSegmentOpticalDepth = 2; }},
    {"tolerance 0.1", [](MarchSettings& m) { m.tolerance = 0.1; }},
    {"tolerance 1", [](MarchSettings& m) { m.tolerance = 1; }},
    {"lightGrid, sunMarchDistanceM 60",
     [](MarchSettings& m) { m.lightGrid = true, m.sunMarchDistanceM = 60; }},
    {"lightGrid, sunMarchDistanceM 200",
     [](MarchSettings& m) { m.lightGrid = true, m.sunMarchDistanceM = 200; }},
};

struct FrontRow {
  Cost whole, later;  // the light grids filled again, if there are any; and not
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
          study.forgetLight();
          rows[i].whole = best(rows[i].whole, study.draw(from));
          rows[i].later = best(rows[i].later, study.draw(from));
          rows[i].error = relativeError(study.picture().radiance, reference);
        }
      }
      std::printf("%-8s %-26s %9s %9s %7s %7s\n", "view", "high with", "ms", "later ms", "times", "error");
      for (std::size_t i = 0; i < rows.size(); ++i) {
        std::printf("%-8s %-26s %9.1f %9.1f %7.1f %7.4f\n", from.name, kChanges[i].name,
                    rows[i].whole.processorMs, rows[i].later.processorMs,
                    plain.processorMs / rows[i].whole.processorMs, rows[i].error);
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
