// What clouds without thickness cost against volumetric ones of the tier low.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "bench/bench_game.h"
#include "bench/expectation.h"
#include "skydrop/render/clouds/cloud_dome.h"
#include "skydrop/render/clouds/cloud_plane.h"

namespace skydrop::bench {
namespace {

constexpr int kFrames = 60;

// Frames of four games of quality low take turns: one plane, three, the dome, volumes. Up at 20 degrees,
// where all of them fill most of the picture.
void cloudSheetsAgainstVolumes(benchmark::State& state) {
  const std::vector<std::string> low = {"quality=low"};
  BenchGame plane({.measuring = true, .scene = "plane1", .set = low}),
      planes({.measuring = true, .scene = "plane3", .set = low}),
      dome({.measuring = true, .scene = "dome", .set = low}),
      volumes({.measuring = true, .scene = "fair", .set = low});
  for (BenchGame* game : {&plane, &planes})
    game->sceneRenderer().renderer().find<render::CloudPlanes>()->waitForNoise();
  dome.sceneRenderer().renderer().find<render::CloudDome>()->waitForNoise();
  app::Pose pose;
  pose.position = {0, plane.ground().height({0, 0}) + 300, 0};
  pose.yawDegrees = 200;
  pose.pitchDegrees = 20;
  const std::vector<BenchGame*> games = {&plane, &planes, &dome, &volumes};
  for (BenchGame* game : games) game->settle(pose);
  for (auto _ : state) {
    for (int frame = 0; frame < kFrames; ++frame)
      for (BenchGame* game : games) game->draw(pose);
    const double planeMs = plane.medianMs("cloudPlanes", kFrames),
                 planesMs = planes.medianMs("cloudPlanes", kFrames),
                 domeMs = dome.medianMs("cloudDome", kFrames),
                 volumesMs = volumes.medianMs("clouds", kFrames);
    std::printf("one plane %.2f ms, three %.2f ms, dome %.2f ms, volumes of the tier low %.2f ms\n", planeMs,
                planesMs, domeMs, volumesMs);
    state.counters["planeRatio"] = planeMs / volumesMs;
    state.counters["planesRatio"] = planesMs / volumesMs;
    state.counters["domeRatio"] = domeMs / volumesMs;
    expect(planeMs > 0 && domeMs > 0 && volumesMs > 0, "a pass of clouds was not drawn");
    expect(planeMs <= volumesMs / 10, "a cloud plane takes more than a tenth of the clouds of the tier low");
    expect(domeMs <= volumesMs / 5, "the cloud dome takes more than a fifth of the clouds of the tier low");
  }
  state.SetLabel(plane.renderer());
}
BENCHMARK(cloudSheetsAgainstVolumes)->Iterations(1)->Unit(benchmark::kSecond)->UseRealTime();

}  // namespace
}  // namespace skydrop::bench
