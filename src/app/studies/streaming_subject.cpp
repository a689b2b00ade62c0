#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "app/studies/subjects.h"
#include "app/studies/table_subject.h"
#include "skydrop/core/job_pool.h"
#include "skydrop/terrain/endless_terrain.h"
#include "skydrop/terrain/noise_height_source.h"

namespace skydrop::app {
namespace {

enum class StreamingPart { revisit, upload, workers };
constexpr std::array<std::string_view, 3> kPartNames = {"revisit", "upload", "workers"};

struct StreamingParameters {
  StreamingPart what = StreamingPart::revisit;
  double cacheMiB = terrain::TerrainStreamingSettings{}.cacheMiB;
  double uploadMiBPerFrame = terrain::TerrainStreamingSettings{}.uploadMiBPerFrame;
  std::int64_t workers = 1;
};

void describe(core::SettingsVisitor& visitor, StreamingParameters& p) {
  visitor.choice(
      "what", p.what, kPartNames,
      {.help = "Chunks made again on the way back, frames with too coarse land after a turn, or the "
               "land that workers make."});
  visitor.number("cacheMiB", p.cacheMiB, {.unit = "MiB", .min = 8, .max = 4096, .help = "Of chunks."});
  visitor.number("uploadMiBPerFrame", p.uploadMiBPerFrame,
                 {.unit = "MiB", .min = 0.25, .max = 128, .help = "To the graphics card."});
  visitor.integer("workers", p.workers,
                  {.unit = "1", .min = 1, .max = 64, .help = "Threads that make land."});
}

// A level look from 300 m up; heading 0 looks north.
terrain::ViewVolume viewFrom(const glm::dvec3& place, double headingDegrees) {
  const glm::dmat3 toView(glm::rotate(glm::dmat4(1), glm::radians(headingDegrees), glm::dvec3(0, 1, 0)));
  return terrain::makeViewVolume(place, toView, glm::radians(60.0), 640, 360);
}

class StreamedLand {
 public:
  explicit StreamedLand(const StreamingParameters& p)
      : pool_(static_cast<int>(p.workers)),
        land_(terrain::makeNoiseHeightSource({}, 1), pool_, settingsOf(p)) {}

  // Out along a line and back, waiting for all land: what had to be made a second time.
  double chunksMadeAgain() {
    std::uint64_t madeOut = 0;
    constexpr int kPlaces = 5;
    for (int i = 0; i < 2 * kPlaces - 1; ++i) {
      const int place = i < kPlaces ? i : 2 * kPlaces - 2 - i;
      land_.settle(viewFrom({0, 600, -2500.0 * place}, 0));
      if (i == kPlaces - 1) madeOut = land_.statistics().generated;
    }
    return static_cast<double>(land_.statistics().generated - madeOut);
  }

  // After a turn to land that is in memory but not on the card: frames until all of it is.
  double framesUntilSharp() {
    land_.settle(viewFrom({0, 600, 0}, 0));
    land_.settle(viewFrom({0, 600, 30000}, 0));  // pushes it off the card
    int frames = 0;
    do {
      land_.update(viewFrom({0, 600, 0}, 0));
      ++frames;
    } while (!land_.isSettled() && frames < 2000);
    return frames;
  }

  double landInView() {
    land_.settle(viewFrom({0, 600, 0}, 0));
    return static_cast<double>(land_.statistics().triangles);
  }

 private:
  static terrain::TerrainStreamingSettings settingsOf(const StreamingParameters& p) {
    terrain::TerrainStreamingSettings settings;
    settings.cacheMiB = p.cacheMiB, settings.uploadMiBPerFrame = p.uploadMiBPerFrame;
    settings.viewDistanceM = 8000;
    settings.gpuMiB = 16;
    return settings;
  }

  core::JobPool pool_;
  terrain::EndlessTerrain land_;
};

class StreamingSubject final : public TableSubject<StreamingParameters> {
  accuracy::Observation compute(const StreamingParameters& p) override {
    accuracy::Observation observation;
    observation.values = {work(p)};
    return observation;
  }
  bool waitsForThreads(const StreamingParameters& p) const override {
    return p.what == StreamingPart::workers;
  }
  double work(const StreamingParameters& p) override {
    StreamedLand land(p);
    if (p.what == StreamingPart::revisit) return land.chunksMadeAgain();
    return p.what == StreamingPart::upload ? land.framesUntilSharp() : land.landInView();
  }
};

}  // namespace

std::unique_ptr<accuracy::Subject> makeStreamingSubject() { return std::make_unique<StreamingSubject>(); }

}  // namespace skydrop::app
