// What the effects of low flight cost a frame: trees, the ground close by and what stands on it, water close
// by, villages.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>
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

// 50 m over villages, their fields and houses in most of the picture.
const Path kPlaces = {"places",
                      "places",
                      "village",
                      8,
                      5,
                      [](const BenchGame& game, int i) {
                        return overLand(game, {-3250 + 22.0 * i, 2560 + 14.0 * i}, 50, 30 + 4.0 * i, -10);
                      },
                      "villages add more to a frame than their share"};

struct Added {
  double share = 0, ms = 0;
};

// With something and without, in turn in one run: the medians over the places of the path.
Added addedOver(const Path& path, BenchGame& with, BenchGame& without) {
  std::vector<double> shares, addedMs;
  for (int place = 0; place < path.places; ++place) {
    const app::Pose pose = path.pose(with, place);
    for (BenchGame* game : {&with, &without}) game->settle(pose), game->draw(pose);
    std::vector<double> on, off;
    for (int i = 0; i < path.frames; ++i) off.push_back(without.draw(pose)), on.push_back(with.draw(pose));
    shares.push_back(medianOf(on) / medianOf(off) - 1);
    addedMs.push_back(medianOf(on) - medianOf(off));
  }
  return {medianOf(shares), medianOf(addedMs)};
}

void note(benchmark::State& state, const char* name, const char* quality, const Added& added) {
  state.counters["added"] = added.share;
  state.counters["addedMs"] = added.ms;
  std::printf("%s of quality %s: %.0f %% more, %.1f ms\n", name, quality, 100 * added.share, added.ms);
}

// An effect also changes the passes of land and sea, so whole frames count.
void added(benchmark::State& state, const Path& path, const char* quality, double mostShare) {
  const auto settings = [&](const char* on) {
    return std::vector<std::string>{std::string("quality=") + quality,
                                    "effects." + std::string(path.effect) + "=" + on, "view.hud=false"};
  };
  BenchGame with({.scene = path.scene, .set = settings("true")});
  BenchGame without({.scene = path.scene, .set = settings("false")});
  for (auto _ : state) {
    const Added found = addedOver(path, with, without);
    note(state, path.name, quality, found);
    expect(found.share <= mostShare, path.promise);
  }
  state.SetLabel(with.renderer());
}

// What a mirrored picture of the water's own adds to a frame that follows rays through the scene's, with
// trees and houses, which it draws a second time. Nothing is promised of it.
void waterMirror(benchmark::State& state, const char* quality) {
  const auto settings = [&](const char* mirror) {
    return std::vector<std::string>{std::string("quality=") + quality,
                                    "waterDetail.reflection=half",
                                    "effects.vegetation=true",
                                    "effects.places=true",
                                    std::string("waterDetail.mirror=") + mirror,
                                    "view.hud=false"};
  };
  BenchGame with({.scene = kWater.scene, .set = settings("plane")});
  BenchGame without({.scene = kWater.scene, .set = settings("picture")});
  for (auto _ : state) note(state, "a mirrored picture", quality, addedOver(kWater, with, without));
  state.SetLabel(with.renderer());
}

void trees(benchmark::State& state, const char* quality, double most) { added(state, kTrees, quality, most); }
void groundDetail(benchmark::State& state, const char* quality, double most) {
  added(state, kGround, quality, most);
}
void water(benchmark::State& state, const char* quality, double most) { added(state, kWater, quality, most); }

void places(benchmark::State& state, const char* quality, double most) {
  added(state, kPlaces, quality, most);
}

// A leg of low flight: two places each, 60 m apart.
struct Leg {
  const char* name;
  glm::dvec2 from;
  double above;  // the land, or the sea where that is higher
  double yaw, pitch;
};
const std::array<Leg, 7> kLegs = {Leg{"wood at 50 m", {-1600, -3300}, 50, 200, -12},
                                  {"hills with woods at 150 m", {500, -3900}, 150, 120, -14},
                                  {"meadow at 20 m", {4420, -530}, 20, 230, -8},
                                  {"rock and scree at 50 m", {3300, -2200}, 50, 230, -12},
                                  {"shore at 20 m", {3930, 6560}, 20, 75, -4},
                                  {"open water at 50 m", {4400, 4300}, 50, 20, -8},
                                  {"land at 400 m", {4420, -530}, 400, 230, -14}};

app::Pose legPose(const BenchGame& game, const Leg& leg, int place) {
  const double yaw = glm::radians(leg.yaw);
  const glm::dvec2 xz = leg.from + 60.0 * place * glm::dvec2(-std::sin(yaw), -std::cos(yaw));
  app::Pose pose = overLand(game, xz, leg.above, leg.yaw, leg.pitch);
  pose.position.y = std::max(pose.position.y, leg.above);
  return pose;
}

// All five effects together against none of them over one path, below clouds (as flights begin) or below a
// clear sky, where a frame costs half as much: the sum of the path's frames, each the fastest of some by the
// processor time of all threads of the process, which other programs disturb less than the wall clock.
void lowFlight(benchmark::State& state, const char* quality, const char* clouds, double mostShare) {
  constexpr int kStops = 2, kFrames = 5;
  const auto settings = [&](const std::string& on) {
    return std::vector<std::string>{std::string("quality=") + quality,
                                    "effects.vegetation=" + on,
                                    "effects.groundDetail=" + on,
                                    "effects.waterDetail=" + on,
                                    "effects.places=" + on,
                                    "effects.groundCover=" + on,
                                    "render.picture.smoothEdges=" + on,
                                    std::string("effects.clouds=") + clouds,
                                    "view.hud=false"};
  };
  BenchGame with({.scene = "woodland", .set = settings("true")});
  BenchGame without({.scene = "woodland", .set = settings("false")});
  const auto processorMs = [](BenchGame& game, const app::Pose& pose) {
    const std::clock_t begin = std::clock();
    game.draw(pose);
    return 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  };
  for (auto _ : state) {
    double allWith = 0, allWithout = 0;
    for (const Leg& leg : kLegs) {
      double legWith = 0, legWithout = 0;
      for (int place = 0; place < kStops; ++place) {
        const app::Pose pose = legPose(with, leg, place);
        for (BenchGame* game : {&with, &without}) game->settle(pose), game->draw(pose);
        std::vector<double> on, off;
        for (int i = 0; i < kFrames; ++i) {
          off.push_back(processorMs(without, pose));
          on.push_back(processorMs(with, pose));
        }
        legWith += std::ranges::min(on), legWithout += std::ranges::min(off);
      }
      std::printf("  %-26s %5.1f -> %5.1f ms, %3.0f %% more\n", leg.name, legWithout / kStops,
                  legWith / kStops, 100 * (legWith / legWithout - 1));
      allWith += legWith, allWithout += legWithout;
    }
    const double share = allWith / allWithout - 1;
    state.counters["added"] = share;
    std::printf("low flight of quality %s, clouds %s: %.0f %% more\n", quality, clouds, 100 * share);
    expect(share <= mostShare,
           "trees, ground, grass, water and villages together add more to low flight than their share");
  }
  state.SetLabel(with.renderer());
}

BENCHMARK_CAPTURE(lowFlight, low, "low", "true", 0.30)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(lowFlight, high, "high", "true", 0.60)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(lowFlight, lowInClearAir, "low", "false", 0.30)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(lowFlight, highInClearAir, "high", "false", 0.60)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

BENCHMARK_CAPTURE(trees, low, "low", 0.30)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(trees, high, "high", 0.60)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(groundDetail, low, "low", 0.30)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(groundDetail, high, "high", 0.30)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(water, low, "low", 0.08)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(water, high, "high", 0.15)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(waterMirror, low, "low")->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(waterMirror, high, "high")->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(waterMirror, ultra, "ultra")->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(places, low, "low", 0.08)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(places, high, "high", 0.15)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace skydrop::bench
