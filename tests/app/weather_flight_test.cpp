// Weather as scenes and command lines have it: refused where it cannot be, flown by the autopilot, recorded
// and replayed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "app/session/flown_weather.h"
#include "app/session/run_config.h"
#include "app/session/simulation.h"
#include "skydrop/core/error.h"
#include "skydrop/core/fixed_step.h"
#include "skydrop/game/flown_clouds.h"
#include "support/instrumented.h"
#include "support/refusal.h"
#include "support/shared_noise.h"
#include "support/soak.h"
#include "support/temporary_folder.h"

namespace skydrop::app {
namespace {

constexpr const char* kWeathers[] = {"breeze", "warmFront", "coldFront", "thunderstorm", "afterRain"};

class WeatherFlight : public testing::Test {
 protected:
  void SetUp() override {
    test::sharedNoise();
    setenv("XDG_CACHE_HOME", test::sharedCacheHome().c_str(), 1);
  }

  static CommandLine lineOf(const std::string& scene) {
    CommandLine line;
    line.verb = Verb::simulate;
    line.scene = scene;
    line.autopilot = true;
    return line;
  }

  static std::string refusalOfScene(const std::string& weather) {
    const test::TemporaryFolder folder;
    CommandLine line = lineOf(folder.write(
        "bad.json", R"({"schema": 1, "effects": ["weather"], "settings": {"weather": )" + weather + "}}"));
    return test::refusalOf<core::DataError>([&] { prepareRun(line); });
  }
};

TEST_F(WeatherFlight, aSceneWithImpossibleWeatherIsRefusedWithPlaceAndReason) {
  // One line that names the file, the place and the reason, for each.
  const auto expectRefused = [](const std::string& weather, const std::string& what) {
    const std::string line = refusalOfScene(weather);
    EXPECT_TRUE(test::isOneLineAbout(line, "bad.json")) << line;
    EXPECT_NE(line.find(what), std::string::npos) << line;
  };
  expectRefused(R"({"sites": [{"layers": [{"base": 2000, "top": 1000}]}]})",
                "weather.sites.0.layers.0: the top at 1000 m is not above the base at 2000 m");
  expectRefused(R"({"sites": [{"layers": [{"cover": 1.5}]}]})", "weather.sites.0.layers.0.cover");
  expectRefused(R"({"sites": [{"rain": -2}]})", "weather.sites.0.rain");
  expectRefused(R"({"sites": [{"windSpeed": null}]})", "weather.sites.0.windSpeed");
  expectRefused(R"({"sites": [{"levels": [{}, {"height": 900}]}]})", "weather.sites.0.wind.levels.1");
  std::string layers = R"({"sites": [{"layers": [{})";
  for (int i = 1; i < 400; ++i) layers += ",{}";
  expectRefused(layers + "]}]}", "layers");
  EXPECT_EQ(refusalOfScene(R"({"sites": [{"layers": [{"base": 900}]}]})"), "");
}

TEST_F(WeatherFlight, anImpossibleSettingOnTheCommandLineIsAUsageError) {
  CommandLine line = lineOf("breeze");
  line.set = {"weather.sites.0.layers.0.base=9000"};
  EXPECT_EQ(test::refusalOf<core::UsageError>([&] { prepareRun(line); }),
            "--set: weather.sites.0.layers.0: the top at 3355 m is not above the base at 9000 m");
}

TEST_F(WeatherFlight, aFlightWithoutTheEffectHasNoneOfIt) {
  // Settings of the weather change nothing, to the bit, where no scene calls for it.
  const auto hashOf = [](const std::vector<std::string>& set) {
    CommandLine line = lineOf("terrain");
    line.set = set;
    const auto run = prepareRun(line);
    Simulation simulation(run->setup, run->settings, run->table);
    for (int i = 0; i < 600; ++i) simulation.step({});
    EXPECT_EQ(simulation.world().now().air.present, simulation.effects().contains(scene::Effect::weather));
    return simulation.world().stateHash();
  };
  EXPECT_EQ(hashOf({}), hashOf({"weather.sites.0.windSpeed=20", "weather.sites.0.layers.0.cover=1"}));
  EXPECT_NE(hashOf({}), hashOf({"effects.weather=true"}));
}

TEST_F(WeatherFlight, aSnapshotTellsTheWeatherOfAnyPlaceAtItsMoment) {
  const auto run = prepareRun(lineOf("coldFront"));
  Simulation simulation(run->setup, run->settings, run->table);
  for (int i = 0; i < 240; ++i) simulation.step({});
  const weather::Moment moment = simulation.world().interpolated(0.25).weather;
  ASSERT_TRUE(moment);
  EXPECT_DOUBLE_EQ(moment.seconds, core::FixedStep::kStepSeconds * 239.25);
  for (const glm::dvec2 place : {glm::dvec2(0), glm::dvec2(20000, -3000)}) {
    const weather::State there =
        weather::stateAt(run->settings.weather, run->setup.seed, moment.seconds, place);
    EXPECT_EQ(moment.at(place), there);
  }
  EXPECT_NE(moment.at({0, 0}), moment.at({20000, -3000}));
  // A change reaches the snapshot of the next step, and the effect that goes takes it along.
  game::World& world = simulation.world();
  game::WeatherSetup changed{run->settings.weather, run->settings.wind, nullptr};
  changed.settings.sites[0].rain = 7.5;
  world.setWeather(changed);
  world.step({});
  EXPECT_EQ(world.now().weather.settings->sites[0].rain, 7.5);
  world.setWeather(std::nullopt);
  world.step({});
  EXPECT_FALSE(world.now().weather);
}

TEST_F(WeatherFlight, cumulusIsTheLayerOfTheSettings) {
  // In a scene of fair weather the flown medium is that of clouds.layers.0, which is drawn without the
  // effect.
  const auto run = prepareRun(lineOf("breeze"));
  const clouds::LayerMedium flown =
      game::cloudLayerOf(weather::stateOf(run->settings.weather.sites[0]).layers[0]);
  EXPECT_EQ(flown.layer, run->settings.clouds.layers[0]);
  EXPECT_EQ(flown.form, clouds::CloudForm{});
}

TEST_F(WeatherFlight, aRecordedFlightInWeatherReplaysEveryBit) {
  // Half a minute of each weather, with a change of the wind in its middle.
  for (const char* scene : kWeathers) {
    const test::TemporaryFolder folder;
    CommandLine line = lineOf(scene);
    line.record = folder.path() / "flight.log";
    {
      const auto run = prepareRun(line);
      Simulation simulation(run->setup, run->settings, run->table);
      for (int i = 0; i < 3600; ++i) {
        if (i == 1800) {
          core::setField(run->table, "weather.sites.0.windSpeed=14");
          simulation.apply({"weather.sites.0.windSpeed"});
        }
        simulation.step({});
      }
      simulation.endRecording();
    }
    CommandLine again;
    again.verb = Verb::simulate;
    again.replay = line.record;
    const auto run = prepareRun(again);
    Simulation replay(run->setup, run->settings, run->table);
    while (!replay.finished()) replay.step({});
    EXPECT_EQ(replay.takeDivergence().value_or(""), "") << scene;
    EXPECT_EQ(replay.world().stepCount(), 3600u);
    EXPECT_TRUE(replay.world().now().air.present);
  }
}

// What came of a number of flights.
struct Flights {
  int crashes = 0;
  std::int64_t scored = 0, missed = 0;
  double lowestM = 1e9;
};

Flights flightsIn(const CommandLine& sceneLine, int seeds, double seconds) {
  Flights sum;
  for (int seed = 1; seed <= seeds; ++seed) {
    CommandLine line = sceneLine;
    line.seed = static_cast<std::uint64_t>(seed);
    const auto run = prepareRun(line);
    Simulation simulation(run->setup, run->settings, run->table);
    for (int i = 0; i < seconds * core::FixedStep::kStepsPerSecond; ++i) {
      simulation.step({});
      sum.lowestM = std::min(sum.lowestM, simulation.world().now().aircraft.heightAboveGround);
      if (i % 1000 != 0) continue;
      for (const game::GameEvent& event : simulation.world().takeEvents())
        sum.crashes += event.kind == game::GameEventKind::crashed;
    }
    for (const game::GameEvent& event : simulation.world().takeEvents())
      sum.crashes += event.kind == game::GameEventKind::crashed;
    sum.scored += simulation.world().now().score;
    sum.missed += simulation.world().now().misses;
  }
  return sum;
}

TEST_F(WeatherFlight, theAutopilotDeliversInFiveWeathersWithoutACrash) {
  // No crash in any; of the packages that came down at least 90 % score outside of thunderstorms.
  const int seeds = test::soaking() ? 20 : test::kInstrumented ? 1 : 3;
  const double seconds = test::soaking() ? 600 : test::kInstrumented ? 60 : 240;
  for (const std::string scene : kWeathers) {
    const Flights flights = flightsIn(lineOf(scene), seeds, seconds);
    const double landed = static_cast<double>(flights.scored + flights.missed);
    std::printf("%s: %lld of %.0f packages scored, %d crashes, never below %.0f m\n", scene.c_str(),
                static_cast<long long>(flights.scored), landed, flights.crashes, flights.lowestM);
    EXPECT_EQ(flights.crashes, 0) << scene;
    if (!test::kInstrumented) {
      EXPECT_GT(landed, seeds) << scene;
    }
    if (scene != "thunderstorm") {
      EXPECT_GE(static_cast<double>(flights.scored), 0.9 * landed) << scene;
    }
  }
}

}  // namespace
}  // namespace skydrop::app
