// What was written with the names of earlier versions still means the same: scenes, presets, the player's
// file, --set.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "app/session/run_config.h"
#include "app/settings/preset_store.h"
#include "skydrop/core/assets.h"
#include "skydrop/core/file.h"
#include "support/temporary_folder.h"

namespace skydrop::app {
namespace {

struct Renamed {
  const char *formerly, *now;
  double value;  // no default
};

// All names that versions since 0.1 have given up.
constexpr Renamed kRenamed[] = {
    {"clouds.densityThreshold", "clouds.layers.0.densityThreshold", 0.4},
    {"clouds.scale", "clouds.layers.0.scale", 0.7},
    {"clouds.anisotropy", "clouds.layers.0.anisotropy", 0.3},
    {"clouds.extinction", "clouds.layers.0.extinction", 0.05},
    {"clouds.higherScale", "clouds.layers.0.higherScale", 25},
    {"clouds.weatherScale", "clouds.layers.0.weatherScale", 0.01},
    {"clouds.cloudHeight", "clouds.layers.0.cloudHeight", 900},
    {"clouds.thickness", "clouds.layers.0.thickness", 700},
    {"clouds.coverage", "clouds.layers.0.coverage", 0.8},
    {"clouds.typeShift", "clouds.layers.0.typeShift", -0.5},
    {"clouds.erosion", "clouds.layers.0.erosion", 0.2},
    {"clouds.forwardShare", "clouds.layers.0.forwardShare", 0.3},
    {"clouds.windSpeed", "wind.speed", 17},
    {"clouds.windDirection", "wind.direction", 90},
    {"clouds.march.stepDepth", "clouds.march.maxSegmentOpticalDepth", 0.5},
    {"clouds.march.leastTransmittance", "clouds.march.transmittanceCutoff", 0.02},
    {"clouds.march.tolerance", "clouds.march.fineTolerance", 0.7},
};

// What versions since 0.1 had and there is no more.
constexpr const char* kRemoved[] = {"clouds.march.seekSteps", "clouds.march.emptyStepMultiplier",
                                    "clouds.march.sunReachM", "clouds.march.sunMarchDistanceM",
                                    "clouds.march.lightGrid", "clouds.march.lightCellM"};

nlohmann::json underFormerNames() {
  nlohmann::json settings;
  for (const Renamed& row : kRenamed) {
    std::string pointer = std::string("/") + row.formerly;
    for (char& c : pointer) c = c == '.' ? '/' : c;
    settings[nlohmann::json::json_pointer(pointer)] = row.value;
  }
  return settings;
}

void expectTaken(const core::SettingsTable& table, const char* by) {
  for (const Renamed& row : kRenamed)
    EXPECT_EQ(table.at(row.now).get(), row.value) << by << ": " << row.formerly;
}

class FormerNames : public testing::Test {
 protected:
  CommandLine line() const {
    CommandLine line;
    line.verb = Verb::simulate;
    line.userDir = folder.path() / "user";
    return line;
  }
  void writePlayersFile(const nlohmann::json& settings) const {
    std::filesystem::create_directories(folder.path() / "user");
    folder.write("user/settings.json", nlohmann::json({{"schema", 1}, {"settings", settings}}).dump());
  }
  static void choose(RunConfig& run, const std::string& path, double value) {
    core::setField(run.table.at(path), value);
    takeMenuChanges(run, {path});
  }
  nlohmann::json kept() const {
    const std::filesystem::path file = folder.path() / "user/settings.json";
    return nlohmann::json::parse(core::readTextFile(file)).value("settings", nlohmann::json::object());
  }

  const test::TemporaryFolder folder;
};

TEST_F(FormerNames, areReadFromAScene) {
  CommandLine scene = line();
  scene.scene =
      folder.write("a.json", nlohmann::json({{"schema", 1}, {"settings", underFormerNames()}}).dump());
  expectTaken(prepareRun(scene)->table, "scene");
}

TEST_F(FormerNames, areReadFromThePlayersFile) {
  writePlayersFile(underFormerNames());
  const auto run = prepareRun(line());
  EXPECT_EQ(run->warning, std::nullopt);
  expectTaken(run->table, "player's file");
}

TEST_F(FormerNames, areTakenByTheCommandLine) {
  CommandLine set = line();
  for (const Renamed& row : kRenamed) {
    set.set.push_back(std::string(row.formerly) + "=" + nlohmann::json(row.value).dump());
  }
  expectTaken(prepareRun(set)->table, "--set");
}

TEST_F(FormerNames, areReadFromAPresetOfTheGroupThatTheyWereIn) {
  // Of rows that have left the group since, only what it sets is set: a default may be none of its choices.
  const nlohmann::json preset = {{"schema", 1}, {"groups", {"clouds"}}, {"settings", underFormerNames()}};
  Settings settings;
  const core::SettingsTable table(settings);
  for (const ui::SettingValue& value : readPreset(folder.write("old.json", preset.dump()))) {
    table.at(value.path).set(value.value);
  }
  expectTaken(table, "preset");
  settings.wind.speed = 33;
  const nlohmann::json other = {
      {"schema", 1}, {"groups", {"clouds"}}, {"settings", {{"clouds", {{"coverage", 1}}}}}};
  for (const ui::SettingValue& value : readPreset(folder.write("new.json", other.dump()))) {
    table.at(value.path).set(value.value);
  }
  EXPECT_EQ(settings.clouds.layers[0].coverage, 1);
  EXPECT_EQ(settings.wind.speed, 33);
}

TEST_F(FormerNames, aChoiceOfTheMenuReplacesThemInThePlayersFile) {
  // A reset too: what the file says under the former name must not come back at the next start.
  writePlayersFile({{"clouds", {{"coverage", 0.8}, {"scale", 0.7}, {"windSpeed", 17}}}});
  const auto run = prepareRun(line());
  choose(*run, "clouds.layers.0.coverage", 0.3);
  choose(*run, "wind.speed", core::SettingsTable(run->base).at("wind.speed").get());
  EXPECT_EQ(run->userSettings.save(run->playerTable, run->bindings), std::nullopt);
  EXPECT_EQ(kept(),
            nlohmann::json::parse(R"({"clouds": {"scale": 0.7, "layers": {"0": {"coverage": 0.3}}}})"));
  const auto next = prepareRun(line());
  EXPECT_EQ(next->settings.clouds.layers[0].coverage, 0.3);
  EXPECT_EQ(next->settings.clouds.layers[0].scale, 0.7);
  EXPECT_EQ(next->settings.wind.speed, core::WindSettings().speed);
}

TEST_F(FormerNames, aChoiceOfTheMenuComesAfterThemOnTheCommandLine) {
  CommandLine set = line();
  set.set = {"clouds.coverage=0.9"};
  const auto run = prepareRun(set);
  choose(*run, "clouds.layers.0.coverage", 0.3);
  choose(*run, "clouds.tier", 1);  // everything is composed again
  EXPECT_EQ(run->settings.clouds.layers[0].coverage, 0.3);
}

TEST_F(FormerNames, aFileMayHaveWhatThereIsNoMore) {
  // A scene is read, and the player's file without a warning, as if they did not set it; --set is told.
  nlohmann::json settings = {{"clouds", {{"coverage", 0.7}}}};
  for (const char* path : kRemoved) settings["clouds"]["march"][std::string(path).substr(13)] = 3;
  writePlayersFile(settings);
  CommandLine scene = line();
  scene.scene = folder.write("a.json", nlohmann::json({{"schema", 1}, {"settings", settings}}).dump());
  const auto run = prepareRun(scene);
  EXPECT_EQ(run->warning, std::nullopt);
  EXPECT_EQ(run->settings.clouds.layers[0].coverage, 0.7);
  for (const char* path : kRemoved) {
    CommandLine set = line();
    set.set = {std::string(path) + "=1"};
    try {
      prepareRun(set);
      ADD_FAILURE() << path << " is taken";
    } catch (const std::exception& error) {
      EXPECT_NE(std::string(error.what()).find("is no setting any more"), std::string::npos) << error.what();
    }
  }
}

TEST_F(FormerNames, areInNoFileThatIsShipped) {
  Settings settings;
  const core::SettingsTable table(settings);
  int rows = 0;
  for (const char* kind : {"scenes", "clouds", "presets"}) {
    for (const auto& entry : std::filesystem::directory_iterator(core::assetPath(kind))) {
      const auto json = nlohmann::json::parse(core::readTextFile(entry.path()));
      const auto flat = json.value("settings", nlohmann::json::object()).flatten();
      for (const auto& [pointer, value] : flat.items()) {
        if (pointer.empty()) continue;
        std::string path = pointer.substr(1);
        for (char& c : path) c = c == '/' ? '.' : c;
        ++rows;
        EXPECT_EQ(table.at(path).path, path) << entry.path();
      }
    }
  }
  EXPECT_GT(rows, 50);
}

}  // namespace
}  // namespace skydrop::app
