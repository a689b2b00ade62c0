// Long flights: every scene that comes with the program, flown by the autopilot and drawn now and then. 12
// simulated seconds by default; three hours with SKYDROP_SOAK=1, or SKYDROP_SOAK_SECONDS (docs/soak.md).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/session/preparations.h"
#include "app/session/run_config.h"
#include "app/session/scene_renderer.h"
#include "app/session/simulation.h"
#include "skydrop/core/fixed_step.h"
#include "skydrop/terrain/endless_terrain.h"
#include "support/gl_test.h"
#include "support/instrumented.h"
#include "support/paths.h"
#include "support/process_memory.h"
#include "support/shared_noise.h"
#include "support/soak.h"

namespace skydrop::app {
namespace {

constexpr Size kSize{96, 54};

// The land's cache; from so long on it is full at half time, and nothing else may grow.
constexpr int kCacheMiB = 16;
constexpr double kLongSeconds = 900;
constexpr double kMiB = 1 << 20;

double flightSeconds() {
  if (const char* seconds = std::getenv("SKYDROP_SOAK_SECONDS")) return std::strtod(seconds, nullptr);
  if (test::soaking()) return 3 * 3600;
  return test::kInstrumented ? 2 : 12;
}

// Of a flight.
int pictures() { return test::triesAll() ? 40 : 24; }

std::vector<std::string> sceneNames() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(test::sourceDir() + "/assets/scenes"))
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  std::ranges::sort(names);
  return names;
}

bool isFinite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

bool isFinite(const game::Snapshot& now) {
  const game::AircraftSnapshot& a = now.aircraft;
  bool finite = isFinite(a.position) && isFinite(a.velocity) && isFinite(a.angularVelocityBody) &&
                std::abs(glm::length(a.orientation) - 1) < 1e-9 && std::isfinite(a.airspeedMps);
  for (const game::PackageSnapshot& package : now.packages)
    finite = finite && isFinite(package.position) && isFinite(package.velocity);
  return finite;
}

// The autopilot's flight through a scene, advanced frame by frame as a window advances it.
class Flight {
 public:
  explicit Flight(const std::string& scene) : run_(prepareRun(lineOf(scene))) {
    simulation_ = std::make_unique<Simulation>(run_->setup, run_->settings, run_->table);
  }

  // Flies on to a time, at so many frames a second. `shown` is called every `everySeconds` or rather more.
  template <typename Shown>
  void flyTo(double seconds, double framesPerSecond, double everySeconds, const Shown& shown) {
    const auto wanted = static_cast<std::uint64_t>(std::llround(seconds * core::FixedStep::kStepsPerSecond));
    while (done_ < wanted) {
      for (int due = clock_.advance(1 / framesPerSecond); due > 0 && done_ < wanted; --due, ++done_) {
        simulation_->step({});
        simulation_->world().takeEvents();
      }
      ASSERT_TRUE(isFinite(now())) << "after " << now().simulatedSeconds << " s";
      if (now().simulatedSeconds < nextShown_) continue;
      nextShown_ = now().simulatedSeconds + everySeconds;
      shown();
    }
  }

  const game::Snapshot& now() const { return simulation_->world().now(); }
  std::uint64_t stateHash() const {
    core::FrameStatistics statistics;
    simulation_->writeTo(statistics);
    return statistics.stateHash;
  }
  const Simulation& simulation() const { return *simulation_; }
  const RunConfig& run() const { return *run_; }

 private:
  static CommandLine lineOf(const std::string& scene) {
    CommandLine line;
    line.verb = Verb::render;
    line.scene = scene;
    line.autopilot = true;
    // A small cache of land: full after minutes, where the shipped one grows for an hour and hides a leak.
    line.set = {"quality=low", "streaming.cacheMiB=" + std::to_string(kCacheMiB)};
    return line;
  }

  std::unique_ptr<RunConfig> run_;
  std::unique_ptr<Simulation> simulation_;
  core::FixedStep clock_;
  std::uint64_t done_ = 0;
  double nextShown_ = 0;
};

// What draws it.
class Drawing {
 public:
  Drawing(render::gl::Context& context, const Flight& flight, int workers) : flight_(flight) {
    const scene::EffectSet& effects = flight.simulation().effects();
    preparations_.begin(effects, Preparation::Maker::processor, flight.run().settings);
    preparations_.waitUntilReady();
    SceneRenderer::Setup setup{effects, flight.simulation().ground(), workers, false,
                               preparations_.results(effects)};
    setup.framesFollow = true;
    sceneRenderer_ = std::make_unique<SceneRenderer>(context, setup, flight.run().settings);
  }

  // What later frames draw with is there: the GPU holds all that it ever will.
  void warmUp() { sceneRenderer_->warmUp(flight_.now(), kSize); }

  void draw(Streaming streaming) { sceneRenderer_->draw(flight_.now(), kSize, streaming); }

  // Whether all the land is there that the view wants, once it has been waited for.
  bool landIsWhole() {
    if (!sceneRenderer_->land()) return true;
    return sceneRenderer_->updateLand(sceneRenderer_->view(flight_.now(), kSize), Streaming::settled);
  }

  // Chunks on the processor's side: those that a view wants are never evicted, so views differ.
  double landBytes() const {
    const terrain::EndlessTerrain* land = sceneRenderer_->land();
    return land ? static_cast<double>(land->statistics().bytes) : 0;
  }

  // Texels of the last frame's light that are no numbers.
  std::size_t notFinite() {
    std::vector<glm::vec4> texels(static_cast<std::size_t>(kSize.width * kSize.height));
    sceneRenderer_->renderer().sceneColor().read(GL_RGBA, GL_FLOAT,
                                                 std::as_writable_bytes(std::span(texels)));
    return static_cast<std::size_t>(std::ranges::count_if(texels, [](const glm::vec4& t) {
      return !std::isfinite(t.x) || !std::isfinite(t.y) || !std::isfinite(t.z) || !std::isfinite(t.w);
    }));
  }

 private:
  const Flight& flight_;
  Preparations preparations_;
  std::unique_ptr<SceneRenderer> sceneRenderer_;
};

// Of the frames of one half of a flight.
struct Held {
  std::uint64_t mostGpuBytes = 0;
  std::vector<double> residentBytes;  // without the land's chunks

  // The median of the later half of its frames, when caches are full: what single views need and what the
  // allocator keeps for a while come and go.
  double resident() const {
    std::vector<double> later(residentBytes.begin() + static_cast<std::ptrdiff_t>(residentBytes.size() / 2),
                              residentBytes.end());
    std::ranges::sort(later);
    return later.at(later.size() / 2);
  }
};

class SceneSoak : public test::GLTest, public testing::WithParamInterface<std::string> {
 protected:
  void SetUp() override {
    setenv("XDG_CACHE_HOME", test::sharedCacheHome().c_str(), 1);
    test::sharedNoise();
    test::GLTest::SetUp();
  }
};

INSTANTIATE_TEST_SUITE_P(, SceneSoak, testing::ValuesIn(sceneNames()), [](const auto& scene) {
  std::string name = scene.param;
  std::ranges::replace(name, '-', '_');
  return name;
});

TEST_P(SceneSoak, staysWhatItIsHoweverLongItIsFlown) {
  // In the second half of the flight the GPU holds at most what it held in the first, and resident memory in
  // its last quarter is less than 1 % above that of the second (after a short flight by no more than the
  // land's cache). States stay finite, and so does every picture's light; no chunk is missing once a view has
  // been waited for; the driver reports no error (the fixture looks). Every fourth frame waits for its land,
  // the others show it as it comes.
  const double seconds = flightSeconds();
  Flight flight(GetParam());
  Drawing drawing(context(), flight, 2);
  drawing.warmUp();
  Held held;
  int frames = 0;
  const auto show = [&] {
    const bool settles = frames++ % 4 == 3;
    drawing.draw(settles ? Streaming::settled : Streaming::asItComes);
    EXPECT_TRUE(!settles || drawing.landIsWhole()) << flight.now().simulatedSeconds << " s";
    EXPECT_EQ(drawing.notFinite(), 0u) << flight.now().simulatedSeconds << " s";
    held.mostGpuBytes = std::max(held.mostGpuBytes, context().resources().bytes());
    held.residentBytes.push_back(static_cast<double>(test::residentBytes()) - drawing.landBytes());
  };
  flight.flyTo(seconds / 2, 60, seconds / pictures(), show);
  if (HasFatalFailure()) return;
  const Held first = std::exchange(held, {});
  flight.flyTo(seconds, 60, seconds / pictures(), show);
  if (HasFatalFailure()) return;
  EXPECT_LE(held.mostGpuBytes, first.mostGpuBytes);
  double grown = held.resident() - first.resident();
  const bool isLong = seconds >= kLongSeconds;
  if (!isLong && grown > kCacheMiB * kMiB) {
    // On a busy machine a light volume may still be worked out, which holds memory once; what is left behind
    // grows again.
    const Held second = std::exchange(held, {});
    flight.flyTo(1.5 * seconds, 60, seconds / pictures(), show);
    if (HasFatalFailure()) return;
    grown = held.resident() - second.resident();
  }
  EXPECT_LE(grown, isLong ? 0.01 * first.resident() : kCacheMiB * kMiB);
  EXPECT_GE(frames, 3 * pictures() / 4);
  std::printf("%s: %.0f s, %lld drops, %u starts; GPU %.1f MiB; resident %.1f and %.1f MiB (%+.2f %%)\n",
              GetParam().c_str(), seconds, static_cast<long long>(flight.now().drops),
              flight.now().aircraft.spawnCount, static_cast<double>(held.mostGpuBytes) / kMiB,
              first.resident() / kMiB, held.resident() / kMiB, 100 * grown / first.resident());
}

TEST_P(SceneSoak, endsInTheSameStateAtAnyFrameRateAndNumberOfWorkers) {
  // At 30, 144 and, where all is tried, 60 frames a second, drawn with land that 1, 8 and 2 workers make;
  // half as long where not all is tried.
  struct Run {
    double framesPerSecond;
    int workers;
  };
  std::vector<Run> runs = {{30, 1}, {144, 8}};
  if (test::triesAll()) runs.push_back({60, 2});
  const double seconds = flightSeconds() * (test::triesAll() ? 1 : 0.5);
  std::vector<std::uint64_t> hashes;
  for (const Run& run : runs) {
    Flight flight(GetParam());
    Drawing drawing(context(), flight, run.workers);
    flight.flyTo(seconds, run.framesPerSecond, seconds / 3, [&] { drawing.draw(Streaming::asItComes); });
    if (HasFatalFailure()) return;
    hashes.push_back(flight.stateHash());
  }
  EXPECT_NE(hashes.front(), Flight(GetParam()).stateHash()) << "nothing has moved";
  for (const std::uint64_t hash : hashes) EXPECT_EQ(hash, hashes.front());
}

}  // namespace
}  // namespace skydrop::app
