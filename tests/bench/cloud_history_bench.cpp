// What the history of the clouds saves in flight, and what it costs in accuracy: straight on, in a turn at 60
// degrees of bank and past clouds' edges at 120 m/s, against the same tier without and the tier reference.
#include <benchmark/benchmark.h>

#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "bench/cloud_study.h"
#include "bench/expectation.h"
#include "skydrop/accuracy/study_flight.h"

namespace skydrop::bench {
namespace {

using clouds::CloudTier, clouds::MarchHistory;

constexpr app::Size kSize{400, 225};
constexpr int kFrames = 40, kFirstTimed = 8;
constexpr std::array kJudged = {8, 24, 39};  // frames
constexpr std::array kHistories = {MarchHistory::off, MarchHistory::quarter, MarchHistory::sixteenth};

struct Path {
  const char* name;
  CloudView begin;
  double speedMps, bankDegrees;
};
constexpr std::array kPaths = {Path{"straight", {"", {0, 600, 0}, 40, 12}, 70, 0},
                               Path{"turn", {"", {0, 900, 0}, 40, 8}, 70, 60},
                               Path{"edges", {"", {600, 2300, 600}, 40, 0}, 120, 0}};

CloudView placeOn(const Path& path, int frame, bool followsLast) {
  CloudView view = path.begin;
  view.seconds = frame / accuracy::kFlightFramesPerSecond;
  view.followsLast = followsLast;
  const glm::dvec3& at = path.begin.position;
  const std::array<double, 6> flown =
      accuracy::flownPose({at.x, at.y, at.z, path.begin.yawDegrees, path.begin.pitchDegrees, 0},
                          {path.speedMps, path.bankDegrees, kFrames}, frame);
  view.position = {flown[0], flown[1], flown[2]};
  view.yawDegrees = flown[3], view.rollDegrees = flown[5];
  return view;
}

struct Row {
  double wallMs = 0, error = 0;  // means over the timed and the judged frames
};

Row flown(CloudStudy& study, const Path& path, const clouds::CloudSettings& settings,
          const std::vector<CloudPicture>& references) {
  study.use(settings);
  study.draw(placeOn(path, 0, true));  // compiles
  study.draw(placeOn(path, 0, false));
  Row row;
  std::size_t judged = 0;
  for (int frame = 0; frame < kFrames; ++frame) {
    const Cost cost = study.draw(placeOn(path, frame, true));
    if (frame >= kFirstTimed) row.wallMs += cost.wallMs / (kFrames - kFirstTimed);
    if (judged >= kJudged.size() || kJudged[judged] != frame) continue;
    row.error += relativeError(study.picture().radiance, references[judged++]) / kJudged.size();
  }
  return row;
}

void historyOfClouds(benchmark::State& state) {
  CloudStudy study(kSize);
  const Path& path = kPaths[static_cast<std::size_t>(state.range(0))];
  for (auto _ : state) {
    std::vector<CloudPicture> references;
    study.use(settingsOf(CloudTier::reference));
    for (const int frame : kJudged) {
      study.draw(placeOn(path, frame, false));
      references.push_back(study.picture());
    }
    for (const CloudTier tier : {CloudTier::medium, CloudTier::high}) {
      Row without;
      for (const MarchHistory history : kHistories) {
        clouds::CloudSettings settings = settingsOf(tier);
        settings.march.history = history;
        const Row row = flown(study, path, settings, references);
        if (history == MarchHistory::off) without = row;
        const std::string who = std::string(path.name) + ' ' +
                                std::string(clouds::kCloudTierNames[static_cast<std::size_t>(tier)]) + ' ' +
                                std::string(clouds::kMarchHistoryNames[static_cast<std::size_t>(history)]);
        std::printf("%-26s %8.1f ms %6.3f of it, error %.4f\n", who.c_str(), row.wallMs,
                    row.wallMs / without.wallMs, row.error);
        std::fflush(stdout);
        if (history != MarchHistory::sixteenth) continue;
        expect(row.wallMs <= without.wallMs / 4, (who + " takes more than a quarter of the time").c_str());
        expect(row.error <= without.error, (who + " errs by more than without history").c_str());
      }
    }
  }
  state.SetLabel(std::string(path.name) + ", " + study.renderer());
}
BENCHMARK(historyOfClouds)->DenseRange(0, 2)->Iterations(1)->Unit(benchmark::kSecond)->UseRealTime();

}  // namespace
}  // namespace skydrop::bench
