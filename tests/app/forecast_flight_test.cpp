// Weather files as flights have them: fed to the world, refused where they cannot be read, recorded and
// replayed.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>

#include "app/session/run_config.h"
#include "app/session/simulation.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "support/margin.h"
#include "support/paths.h"
#include "support/refusal.h"
#include "support/shared_noise.h"
#include "support/temporary_folder.h"

namespace skydrop::app {
namespace {

std::string corpusFile(const std::string& name) {
  return test::sourceDir() + "/tests/corpus/weather/" + name;
}

class ForecastFlight : public testing::Test {
 protected:
  void SetUp() override {
    test::sharedNoise();
    setenv("XDG_CACHE_HOME", test::sharedCacheHome().c_str(), 1);
  }

  static CommandLine lineOf(const std::string& file) {
    CommandLine line;
    line.verb = Verb::simulate;
    line.scene = "terrain";
    line.autopilot = true;
    line.set = {"effects.weather=true", "weather.variability=0"};
    line.weatherFiles = {file};
    return line;
  }

  // The hash after so many steps, of a flight whose sun's clock changes after half of them.
  static std::uint64_t fly(const CommandLine& line, int steps = 1200) {
    const auto run = prepareRun(line);
    Simulation simulation(run->setup, run->settings, run->table);
    for (int i = 0; i < steps && !simulation.finished(); ++i) {
      if (i == steps / 2 && run->recorder) {
        core::setField(run->table, "sky.timeScale=600");
        simulation.apply({"render.sun.timeScale"});
      }
      simulation.step({});
    }
    simulation.endRecording();
    EXPECT_FALSE(simulation.hasDiverged()) << simulation.takeDivergence().value_or("");
    return simulation.world().stateHash();
  }
};

TEST_F(ForecastFlight, theClockOfTheSkyDecidesTheHour) {
  // 14:30 of the file is the mean of its 14 and 15 o'clock; without the clock of the sky the rows decide.
  const auto temperatureAt = [](const std::vector<std::string>& set) {
    CommandLine line = lineOf(corpusFile("goodMeteoblue.json"));
    line.set.insert(line.set.end(), set.begin(), set.end());
    const auto run = prepareRun(line);
    const Simulation simulation(run->setup, run->settings, run->table);
    return simulation.world().now().weather.at({0, 0}).temperatureC;
  };
  const std::string clock = "sky.sun=clock", utc = "sky.utc=2026-06-21T";
  const double two = temperatureAt({clock, utc + "02:00Z"}), three = temperatureAt({clock, utc + "03:00Z"});
  EXPECT_NE(two, three);
  EXPECT_NEAR(temperatureAt({clock, utc + "02:30Z"}), (two + three) / 2, 1e-9);
  EXPECT_NEAR(temperatureAt({clock, utc + "01:00Z", "sky.shiftHours=1.5"}), (two + three) / 2, 1e-9);
  EXPECT_EQ(temperatureAt({"weatherFile.hour=4"}), two) << "the file begins at 22:00 UTC of the day before";
  EXPECT_EQ(temperatureAt({clock, utc + "12:00Z", "weatherFile.followsSky=false", "weatherFile.hour=4"}),
            two);
}

TEST_F(ForecastFlight, aStartOutsideOfItsHoursIsSaid) {
  CommandLine line = lineOf(corpusFile("goodMeteoblue.json"));
  EXPECT_TRUE(prepareRun(line)->notes.empty());
  line.set.insert(line.set.end(), {"sky.sun=clock", "sky.utc=2026-06-25"});
  const auto run = prepareRun(line);
  ASSERT_EQ(run->notes.size(), 1u);
  EXPECT_NE(run->notes[0].find(
                "the flight begins after its last hour, 2026-06-21T21:00:00Z, whose weather is held"),
            std::string::npos)
      << run->notes[0];
}

TEST_F(ForecastFlight, theFarSiteLiesWhereItsFileSays) {
  CommandLine line = lineOf(corpusFile("goodMeteoblue.json"));
  line.farWeatherFiles = {corpusFile("goodOpenMeteo.json")};
  line.set.insert(line.set.end(), {"sky.sun=clock", "sky.utc=2026-06-21T12:00Z"});
  const auto run = prepareRun(line);
  const weather::Moment moment = Simulation(run->setup, run->settings, run->table).world().now().weather;
  ASSERT_TRUE(moment.forecast && moment.forecast->farFromNear);
  const glm::dvec2 far(moment.forecast->farFromNear->x, -moment.forecast->farFromNear->y);
  EXPECT_NEAR(far.y, -32247, 10) << "half a degree north";
  const double noon = 1782043200000;
  EXPECT_EQ(moment.at({0, 0}), moment.forecast->near.at(noon));
  EXPECT_EQ(moment.at(far), moment.forecast->far.at(noon));
  EXPECT_NE(moment.at({0, 0}), moment.at(far));
}

TEST_F(ForecastFlight, D13_aReplayNeedsTheSameContentAndThenRepeatsEveryBit) {
  test::noFaults("D13", "differences");
  const test::TemporaryFolder folder;
  const std::string text = core::readTextFile(corpusFile("goodMeteoblue.json"));
  const std::string file = folder.write("near.json", text);
  CommandLine line = lineOf(file);
  line.farWeatherFiles = {corpusFile("goodOpenMeteo.json")};
  line.set.insert(line.set.end(), {"sky.sun=clock", "sky.utc=2026-06-21T11:00Z"});
  line.record = folder.path() / "flight.log";
  const std::uint64_t flown = fly(line);

  CommandLine replay;
  replay.verb = Verb::simulate;
  replay.replay = line.record;
  EXPECT_EQ(fly(replay), flown) << "the files are found where they were";
  replay.weatherFiles = {folder.write("elsewhere.json", text)};
  const std::string count = test::refusalOf<core::DataError>([&] { prepareRun(replay); });
  EXPECT_NE(count.find("was flown in 2 weather files, and not in the 1 that are given"), std::string::npos)
      << count;
  replay.farWeatherFiles = line.farWeatherFiles;
  EXPECT_EQ(fly(replay), flown);

  folder.write("near.json", text + " ");
  replay.weatherFiles = replay.farWeatherFiles = {};
  const std::string changed = test::refusalOf<core::DataError>([&] { prepareRun(replay); });
  EXPECT_TRUE(test::isOneLineAbout(changed, "near.json")) << changed;
  EXPECT_NE(changed.find("had another content"), std::string::npos) << changed;
  std::filesystem::remove(file);
  EXPECT_TRUE(
      test::isOneLineAbout(test::refusalOf<core::DataError>([&] { prepareRun(replay); }), "near.json"));
}

TEST_F(ForecastFlight, aSceneNamesItsFilesBesideIt) {
  const test::TemporaryFolder folder;
  folder.write("w.json", core::readTextFile(corpusFile("goodMeteoblue.json")));
  const auto prepare = [&](const std::string& members) {
    CommandLine line;
    line.verb = Verb::simulate;
    line.scene = folder.write("s.json", R"({"schema": 1, "effects": ["weather"], )" + members + "}");
    return prepareRun(line);
  };
  EXPECT_TRUE(prepare(R"("weatherFile": "w.json")")->setup.forecast);
  EXPECT_TRUE(prepare(R"("weatherFile": ["w.json"], "farWeatherFile": "w.json")")->setup.forecast);
  const auto refusal = [&](const std::string& members) {
    return test::refusalOf<core::DataError>([&] { prepare(members); });
  };
  EXPECT_NE(refusal(R"("weatherFile": "none.json")").find("none.json"), std::string::npos);
  EXPECT_NE(refusal(R"("weatherFile": "")").find("weatherFile: is empty"), std::string::npos);
  EXPECT_NE(refusal(R"("farWeatherFile": "w.json")").find("there is no weatherFile"), std::string::npos);
  EXPECT_NE(refusal(R"("effects": [], "weatherFile": "w.json")"), "");
}

}  // namespace
}  // namespace skydrop::app
