// The autopilot on strips in the wind, gusts and draughts of scenes with weather; and that logs of such
// flights are flown again bit by bit, and those of flights without a gear as before.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "app/session/run_config.h"
#include "app/session/simulation.h"
#include "skydrop/core/fixed_step.h"
#include "support/instrumented.h"
#include "support/shared_noise.h"
#include "support/soak.h"
#include "support/temporary_folder.h"

namespace skydrop::app {
namespace {

constexpr const char* kWeathers[] = {"breeze", "warmFront", "coldFront", "thunderstorm", "afterRain"};

struct Landings {
  int stops = 0, touches = 0, crashes = 0, flown = 0;
  double hardestMps = 0;
  std::string reasons;
};

class WeatherLanding : public testing::Test {
 protected:
  void SetUp() override {
    test::sharedNoise();
    setenv("XDG_CACHE_HOME", test::sharedCacheHome().c_str(), 1);
  }

  static CommandLine lineOf(const std::string& scene, std::uint64_t seed) {
    CommandLine line;
    line.verb = Verb::simulate;
    line.scene = scene;
    line.autopilot = true;
    line.seed = seed;
    line.set = {"effects.groundHandling=true", "effects.targets=false", "strips.density=1",
                "autopilot.landEvery=1"};
    return line;
  }

  // From the final of a strip on.
  static void fly(const std::string& scene, std::uint64_t seed, double seconds, Landings& sum) {
    const auto run = prepareRun(lineOf(scene, seed));
    run->setup.scene.start.strip = scene::StripStart::final;
    Simulation simulation(run->setup, run->settings, run->table);
    ++sum.flown;
    bool rolled = false;
    for (int i = 0; i < seconds * core::FixedStep::kStepsPerSecond; ++i) {
      simulation.step({});
      const game::GearSnapshot& gear = simulation.world().now().aircraft.gear;
      if (gear.wheelsDown > 0 && gear.groundSpeedMps > 20) rolled = true;
      if (rolled && gear.wheelsDown > 0 && gear.groundSpeedMps < 0.2) ++sum.stops, rolled = false;
      for (const game::GameEvent& event : simulation.world().takeEvents()) {
        if (event.kind == game::GameEventKind::touchedDown) {
          ++sum.touches;
          sum.hardestMps = std::max(sum.hardestMps, event.sinkRate);
        }
        if (event.kind == game::GameEventKind::tookOff) rolled = false;
        if (event.kind != game::GameEventKind::crashed) continue;
        ++sum.crashes;
        sum.reasons += std::to_string(seed) + ": " + gear.endReason + "; ";
      }
    }
  }
};

TEST_F(WeatherLanding, inFiveWeathersTheAutopilotLands) {
  const int seeds = test::soaking() ? 20 : test::kInstrumented ? 1 : 3;
  const double seconds = test::soaking() ? 600 : test::kInstrumented ? 60 : 300;
  for (const std::string scene : kWeathers) {
    Landings all;
    for (int seed = 1; seed <= seeds; ++seed) fly(scene, static_cast<std::uint64_t>(seed), seconds, all);
    std::printf("%s: %d flights of %.0f s, %d stops, %d touches, hardest %.2f m/s, %d crashes %s\n",
                scene.c_str(), all.flown, seconds, all.stops, all.touches, all.hardestMps, all.crashes,
                all.reasons.c_str());
    EXPECT_LE(all.crashes, all.flown / 20) << scene;  // one flight in twenty
    if (scene == "breeze" && !test::kInstrumented) {
      EXPECT_GE(all.stops, all.flown - 1);
    }
    if (scene == "thunderstorm") {
      EXPECT_EQ(all.touches, 0) << "gusts that it does not land in";
    }
  }
}

TEST_F(WeatherLanding, aRecordedTakeOffReplaysEveryBit) {
  const test::TemporaryFolder folder;
  constexpr std::uint64_t kSteps = 40 * 120;
  CommandLine line = lineOf("airstrip", 1);
  line.record = folder.path() / "flight.log";
  int tookOff = 0;
  {
    const auto run = prepareRun(line);
    Simulation simulation(run->setup, run->settings, run->table);
    for (std::uint64_t i = 0; i < kSteps; ++i) simulation.step({});
    for (const game::GameEvent& event : simulation.world().takeEvents())
      tookOff += event.kind == game::GameEventKind::tookOff;
    simulation.endRecording();
  }
  EXPECT_EQ(tookOff, 1);
  CommandLine again;
  again.verb = Verb::simulate;
  again.replay = line.record;
  const auto run = prepareRun(again);
  Simulation replay(run->setup, run->settings, run->table);
  while (!replay.finished()) replay.step({});
  EXPECT_EQ(replay.takeDivergence().value_or(""), "");
  EXPECT_EQ(replay.world().stepCount(), kSteps);
  EXPECT_GT(replay.world().now().aircraft.heightAboveGround, 20);
}

}  // namespace
}  // namespace skydrop::app
