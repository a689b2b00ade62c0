// What clouds cost and how exact they are, tier by tier, against the plain march of the thesis (time) and the
// tier reference (error); what they hold on the GPU; what a clear sky costs.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "app/measure/frame_times.h"
#include "app/measure/stopwatch.h"
#include "bench/bench_game.h"
#include "bench/cloud_study.h"
#include "bench/expectation.h"

namespace skydrop::bench {
namespace {

using clouds::CloudTier;

constexpr app::Size kStudySize{800, 600};
constexpr int kRounds = 2;

struct Front {
  double times;  // as fast as the plain march
  double error;  // relative, at most
};

// What a tier is to reach in every view, and what it may not fall behind in each of kCloudViews.
struct TierPromise {
  CloudTier tier;
  std::optional<Front> promised;
  std::array<Front, 4> floor;  // times 0: none
};

constexpr TierPromise kPromises[] = {
    {CloudTier::low, Front{60, 0.08}, {Front{40, 0.079}, {70, 0.056}, {42, 0.087}, {56, 0.077}}},
    {CloudTier::medium, Front{25, 0.03}, {Front{22, 0.048}, {54, 0.035}, {22, 0.055}, {38, 0.053}}},
    {CloudTier::high, Front{16, 0.02}, {Front{7.6, 0.022}, {29, 0.019}, {7.6, 0.025}, {15, 0.024}}},
    {CloudTier::ultra, {}, {}}};

// What a picture of single rays is off by besides.
struct Faults {
  double bias = 0;   // of the sum of light
  double holes = 0;  // share of rays that lose more than half of their light, of those of an opacity above .1
};

Faults faultsOf(const std::vector<glm::vec3>& radiance, const CloudPicture& reference) {
  double sum = 0, expected = 0;
  std::size_t holes = 0, count = 0;
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    if (reference.opacity[i] <= 0.01f) continue;
    const auto lightOf = [](const glm::vec3& v) { return static_cast<double>(v.x) + v.y + v.z; };
    const double light = lightOf(radiance[i]), right = lightOf(reference.radiance[i]);
    sum += light;
    expected += right;
    if (reference.opacity[i] <= 0.1f) continue;
    ++count;
    holes += light < 0.5 * right;
  }
  return {sum / expected - 1, static_cast<double>(holes) / static_cast<double>(count)};
}

const char* nameOf(CloudTier tier) { return clouds::kCloudTierNames[static_cast<std::size_t>(tier)].data(); }

void printRow(const CloudView& view, const char* tier, const Cost& cost, const Cost& plain, double error,
              const Faults& faults = {}) {
  std::printf("%-8s %-9s %9.1f %9.1f %7.1f %7.1f %8.4f %+8.2f%% %7.3f%%\n", view.name, tier, cost.processorMs,
              cost.wallMs, plain.processorMs / cost.processorMs, plain.wallMs / cost.wallMs, error,
              100 * faults.bias, 100 * faults.holes);
  std::fflush(stdout);
}

void checkFront(const std::string& who, const Front& front, const char* kind, double times, double error) {
  const auto figure = [](double value) { return std::to_string(value).substr(0, 5); };
  const std::string slow = who + " take more than 1/" + figure(front.times) + " of the plain march's time (" +
                           kind + ")",
                    far = who + " are off by more than " + figure(front.error) + " (" + kind + ")";
  expect(times >= front.times, slow.c_str());
  expect(error <= front.error, far.c_str());
}

void checkPromise(const TierPromise& promise, std::size_t view, double times, double error,
                  const Faults& faults) {
  const std::string who =
      std::string("clouds of the tier ") + nameOf(promise.tier) + " from " + kCloudViews[view].name;
  if (promise.floor[view].times > 0) checkFront(who, promise.floor[view], "floor", times, error);
  if (promise.promised) checkFront(who, *promise.promised, "promise", times, error);
  const double most = promise.tier == CloudTier::low ? 0.01 : 0.005;
  expect(std::abs(faults.bias) < most, (who + " are brighter or darker than they may be").c_str());
  if (promise.tier == CloudTier::high)
    expect(faults.holes <= 2e-4, (who + " have more than .02 % of holes").c_str());
}

struct TierRow {
  Cost cost;
  double error = 0;
  Faults faults;
};

// Clouds that end at 24 km, without a far field: with no sky behind them, what lies beyond, most of it light
// of the air, would count as cloud against black. Judged in farFieldOfClouds and in the study clouds-far.
clouds::CloudSettings nearSettingsOf(CloudTier tier) {
  clouds::CloudSettings settings = settingsOf(tier);
  settings.fadeDistance = 24000;
  settings.march.farStartM = 60000;
  return settings;
}

// The plain march and the tiers take turns.
void tiersOfClouds(benchmark::State& state) {
  CloudStudy study(kStudySize);
  const CloudView& from = kCloudViews[static_cast<std::size_t>(state.range(0))];
  for (auto _ : state) {
    study.use(nearSettingsOf(CloudTier::reference));
    const Cost ofReference = study.draw(from);
    const CloudPicture reference = study.picture();
    study.use(nearSettingsOf(CloudTier::low));  // what the plain march's frames draw besides
    std::array<TierRow, std::size(kPromises)> rows;
    Cost plain;
    for (int round = 0; round < kRounds; ++round) {
      plain = best(plain, study.drawPlain(from));
      for (std::size_t i = 0; i < rows.size(); ++i) {
        study.use(nearSettingsOf(kPromises[i].tier));
        study.draw(from);  // makes the textures of its size
        for (int again = 0; again < 2; ++again) rows[i].cost = best(rows[i].cost, study.draw(from));
        const CloudPicture picture = study.picture();
        rows[i].error = relativeError(picture.radiance, reference);
        rows[i].faults = faultsOf(picture.radiance, reference);
      }
    }
    std::printf("%-8s %-9s %9s %9s %7s %7s %8s %9s %8s\n", "view", "tier", "ms", "wall ms", "times",
                "by wall", "error", "bias", "holes");
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const TierPromise& promise = kPromises[i];
      const double times = plain.processorMs / rows[i].cost.processorMs;
      printRow(from, nameOf(promise.tier), rows[i].cost, plain, rows[i].error, rows[i].faults);
      checkPromise(promise, static_cast<std::size_t>(state.range(0)), times, rows[i].error, rows[i].faults);
      state.counters[std::string(nameOf(promise.tier)) + "Times"] = times;
      state.counters[std::string(nameOf(promise.tier)) + "Error"] = rows[i].error;
    }
    printRow(from, "plain", plain, plain, relativeError(study.plainRadiance(), reference));
    printRow(from, "reference", ofReference, plain, 0);
  }
  state.SetLabel(std::string(from.name) + ", " + study.renderer());
}
BENCHMARK(tiersOfClouds)->DenseRange(0, 3)->Iterations(1)->Unit(benchmark::kSecond)->UseRealTime();

// Clouds to 60 km against clouds that end at 24 km: frames take turns.
void farFieldOfClouds(benchmark::State& state) {
  constexpr int kFrames = 6;
  CloudStudy study({640, 360});
  const CloudView& from = kCloudViews[static_cast<std::size_t>(state.range(0))];
  for (auto _ : state) {
    std::printf("%-8s %-9s %9s %9s %7s\n", "view", "tier", "ms", "to 24 km", "ratio");
    for (const CloudTier tier : {CloudTier::low, CloudTier::medium, CloudTier::high}) {
      const clouds::CloudSettings far = settingsOf(tier);
      const clouds::CloudSettings near = nearSettingsOf(tier);
      Cost ofFar, ofNear;
      for (int i = 0; i < kFrames; ++i) {
        study.use(near);
        const Cost now = study.draw(from);
        study.use(far);
        const Cost then = study.draw(from);
        if (i == 0) continue;  // makes programs and textures
        ofNear = best(ofNear, now);
        ofFar = best(ofFar, then);
      }
      const double ratio = ofFar.processorMs / ofNear.processorMs;
      std::printf("%-8s %-9s %9.1f %9.1f %7.2f\n", from.name, nameOf(tier), ofFar.processorMs,
                  ofNear.processorMs, ratio);
      std::fflush(stdout);
      state.counters[std::string(nameOf(tier)) + "Ratio"] = ratio;
      if (tier == CloudTier::high)
        expect(
            ratio <= 1.15,
            (std::string("the far field takes more than .15 of the clouds' pass from ") + from.name).c_str());
    }
  }
  state.SetLabel(std::string(from.name) + ", " + study.renderer());
}
BENCHMARK(farFieldOfClouds)->DenseRange(0, 3)->Iterations(1)->Unit(benchmark::kSecond)->UseRealTime();

// Clouds lit by a light volume against those lit by octaves: frames take turns.
void lightOfClouds(benchmark::State& state) {
  constexpr int kFrames = 6;
  CloudStudy study({640, 360});
  const CloudView& from = kCloudViews[static_cast<std::size_t>(state.range(0))];
  for (auto _ : state) {
    std::printf("%-8s %-9s %9s %9s %7s\n", "view", "tier", "volume ms", "octaves", "ratio");
    for (const CloudTier tier : {CloudTier::low, CloudTier::medium, CloudTier::high}) {
      const clouds::CloudSettings octaves = settingsOf(tier);
      clouds::CloudSettings volume = octaves;
      volume.light = clouds::CloudLight::volume;
      Cost ofVolume, ofOctaves;
      for (int i = 0; i < kFrames; ++i) {
        study.use(octaves);
        const Cost now = study.draw(from);
        study.use(volume);
        study.draw(from);  // solves it
        const Cost then = study.draw(from);
        if (i == 0) continue;  // makes programs and textures
        ofOctaves = best(ofOctaves, now);
        ofVolume = best(ofVolume, then);
      }
      const double ratio = ofVolume.processorMs / ofOctaves.processorMs;
      std::printf("%-8s %-9s %9.1f %9.1f %7.2f\n", from.name, nameOf(tier), ofVolume.processorMs,
                  ofOctaves.processorMs, ratio);
      std::fflush(stdout);
      state.counters[std::string(nameOf(tier)) + "Ratio"] = ratio;
    }
  }
  state.SetLabel(std::string(from.name) + ", " + study.renderer());
}
BENCHMARK(lightOfClouds)->DenseRange(0, 3)->Iterations(1)->Unit(benchmark::kSecond)->UseRealTime();

// Flight under a sun that moves by a degree every 20 frames, so that a volume is solved nearly all the time,
// against the same with octaves: frames take turns. A whole new weather now and then is solved in a sketch
// first.
void solvingLight(benchmark::State& state) {
  constexpr int kPeriod = 20;
  const std::string quality = state.range(0) == 0 ? "low" : "high";
  const int frames = state.range(0) == 0 ? 600 : 200;  // those of high take four times as long
  const auto setup = [&](const std::string& light) {
    return BenchGame::Setup{.scene = "fair", .set = {"quality=" + quality, "clouds.light=" + light}};
  };
  BenchGame volume(setup("volume")), octaves(setup("octaves"));
  app::Pose pose;
  pose.position = {0, 600, 0};
  pose.pitchDegrees = 12;
  volume.settle(pose);
  octaves.settle(pose);
  for (BenchGame* game : {&volume, &octaves}) game->sceneRenderer().setFramesFollow(true);
  for (auto _ : state) {
    app::FrameTimes ofVolume, ofOctaves;
    for (int frame = 0; frame < frames; ++frame) {
      if (frame % kPeriod == 0) {
        const std::string sun = "render.sun.elevationDegrees=" + std::to_string(20 + frame / kPeriod);
        volume.set(sun);
        octaves.set(sun);
      }
      pose.position.x += 2;
      ofVolume.add(volume.draw(pose));
      ofOctaves.add(octaves.draw(pose));
    }
    const auto relative = [](const app::FrameTimes& times) {
      return times.quantile(0.99) / times.quantile(0.5);
    };
    state.counters["volumeMs"] = ofVolume.quantile(0.5);
    state.counters["octavesMs"] = ofOctaves.quantile(0.5);
    state.counters["volumeP99"] = relative(ofVolume);
    state.counters["octavesP99"] = relative(ofOctaves);
    const double ratio = ofVolume.quantile(0.99) / ofOctaves.quantile(0.99);
    state.counters["ratio"] = ratio;
    expect(ratio <= 1.25,
           "p99 of frame times while a light volume is solved is more than 1.25 times that without");
  }
  state.SetLabel(quality + ", " + volume.renderer());
}
BENCHMARK(solvingLight)->DenseRange(0, 1)->Iterations(1)->Unit(benchmark::kSecond)->UseRealTime();

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

// What a slider that changes the field costs the frame after: occupancy and what is made beside it.
void sliderOfClouds(benchmark::State& state) {
  CloudStudy study({64, 36});
  clouds::CloudSettings settings = settingsOf(CloudTier::high);
  for (auto _ : state) {
    app::FrameTimes ms;
    for (int i = 0; i < 21; ++i) {
      settings.layers[0].coverage = 0.4 + 0.01 * i;
      const app::Stopwatch watch;
      study.use(settings);
      ms.add(watch.ms());
    }
    state.counters["ms"] = ms.quantile(0.5);
    expect(ms.quantile(0.5) <= 20, "a slider of the clouds' field takes more than 20 ms");
  }
}
BENCHMARK(sliderOfClouds)->Iterations(1)->Unit(benchmark::kSecond)->UseRealTime();

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
    expect(ratio <= 1.05, "a clear sky takes more than 1.05 times the frame without the effect clouds");
  }
  state.SetLabel(with.renderer());
}
BENCHMARK(clearSky)->Iterations(1)->Unit(benchmark::kSecond)->UseRealTime();

}  // namespace
}  // namespace skydrop::bench
