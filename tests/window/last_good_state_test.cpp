// docs/failures.md: bad data while flying leaves the last good state and a line. Every file that is read
// while flying is broken in the real window; then it is repaired.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <sstream>
#include <string>

#include "support/paths.h"
#include "window/flown_game.h"

namespace skydrop::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string fault(const json& s) { return s.at("window").at("fault").get<std::string>(); }
std::int64_t framesOf(const json& s) { return s.at("frame").at("count").get<std::int64_t>(); }

std::string contentOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void writeTo(const fs::path& file, const std::string& content) {
  std::ofstream(file, std::ios::binary) << content;
}

// A flight with data of its own, which may be broken.
class LastGoodState : public testing::Test {
 protected:
  void SetUp() override {
    SKIP_WITHOUT_DISPLAY();
    for (const char* folder : {"assets", "shaders"}) {
      fs::copy(fs::path(sourceDir()) / folder, data() / folder, fs::copy_options::recursive);
    }
  }

  fs::path data() const { return folder_.path(); }

  void fly(std::vector<std::string> words = {}) {
    flown_ = std::make_unique<FlownGame>(
        FlownGame::Launch{.words = std::move(words), .environment = {"SKYDROP_DATA_DIR=" + data().string()}});
  }
  FlownGame& flown() { return *flown_; }

  // The game shows a line that names the file, and goes on.
  void expectFault(const std::string& file) {
    ASSERT_TRUE(flown().waitFor([&](const json& s) { return fault(s).find(file) != std::string::npos; }))
        << file << ": " << fault(flown().statistics()) << flown().log();
    const std::int64_t frames = framesOf(flown().statistics());
    ASSERT_TRUE(flown().waitFor([&](const json& s) { return framesOf(s) > frames + 3; })) << flown().log();
    EXPECT_NE(fault(flown().statistics()).find(file), std::string::npos) << "it stands until it is repaired";
  }
  void expectSound() {
    ASSERT_TRUE(flown().waitFor([](const json& s) { return fault(s).empty(); }))
        << fault(flown().statistics());
  }
  // So many lines of the log name the file.
  std::ptrdiff_t linesAbout(const std::string& file) {
    std::istringstream log(flown().log());
    std::ptrdiff_t lines = 0;
    for (std::string line; std::getline(log, line);) lines += line.find(file) != std::string::npos ? 1 : 0;
    return lines;
  }

  // In the open menu's search field.
  void openMenu() {
    flown().press("F1");
    ASSERT_TRUE(flown().waitFor([](const json& s) { return s.at("window").at("menuOpen").get<bool>(); }));
  }
  void enter(const std::string& assignment) {
    flown().press("ctrl+f");
    flown().type(assignment);
    flown().press("Return");
  }

 private:
  TemporaryFolder folder_;
  std::unique_ptr<FlownGame> flown_;
};

TEST_F(LastGoodState, aBrokenShaderOfAnyKindLeavesTheOneBeforeIt) {
  // A vertex, a fragment and a compute shader, a file that others include, and the interface's own.
  fly({"--scene", "fair"});
  for (const char* name : {"terrain/depth.vert", "sky/sky.frag", "clouds/march_tiles.comp", "frame.glsl",
                           "imgui/imgui.frag", "tone_map/tone_map.frag"}) {
    const fs::path file = data() / "shaders" / name;
    const std::string good = contentOf(file);
    writeTo(file, good + "\nthis is no shader\n");
    expectFault(name);
    EXPECT_EQ(linesAbout(name), 1) << flown().log();
    writeTo(file, good);
    expectSound();
  }
}

TEST_F(LastGoodState, aBrokenSceneLeavesTheFlightAndARepairedOneReplacesIt) {
  fly();
  const fs::path file = data() / "assets/scenes/terrain.json";
  const std::string good = contentOf(file);
  const std::string hash = flown().statistics().at("stateHash");
  writeTo(file, good.substr(0, good.size() / 2));
  expectFault("terrain.json");
  const auto steps = flown().statistics().at("steps").get<std::int64_t>();
  ASSERT_TRUE(flown().waitFor([&](const json& s) { return s.at("steps").get<std::int64_t>() > steps; }));
  std::string clouded = good;
  clouded.replace(clouded.find("\"terrain\""), 9, "\"terrain\", \"clouds\"");
  writeTo(file, clouded);
  ASSERT_TRUE(flown().waitFor([](const json& s) {
    return s.at("passes").contains("clouds") && fault(s).empty();
  })) << flown().log();
}

TEST_F(LastGoodState, aSceneWhosePartsAreBrokenLeavesTheFlight) {
  // The scene reads well, but what it needs again does not: a shader that was not in use before, the model.
  fly();
  const fs::path scene = data() / "assets/scenes/terrain.json";
  const std::string good = contentOf(scene);
  std::string clouded = good;
  clouded.replace(clouded.find("\"terrain\""), 9, "\"terrain\", \"clouds\"");
  for (const char* name : {"shaders/clouds/march_tiles.comp", "assets/models/airplane.glb"}) {
    const fs::path part = data() / name;
    const std::string goodPart = contentOf(part);
    writeTo(part, "broken");
    writeTo(scene, clouded);
    expectFault(part.filename().string());
    EXPECT_FALSE(flown().statistics().at("passes").contains("clouds"));
    writeTo(part, goodPart);
    writeTo(scene, good);
    expectSound();
  }
}

TEST_F(LastGoodState, aBrokenElevationFileOrImageLeavesTheLandAndARepairedOneReplacesIt) {
  const fs::path land = data() / "assets/elevation/mittelland.tif",
                 image = data() / "assets/elevation/mittelland_aerial.tif";
  fly({"--scene", "terrain", "--elevation", land.string(), "--image", image.string()});
  for (const fs::path& file : {land, image}) {
    const std::string good = contentOf(file);
    writeTo(file, good.substr(0, good.size() / 2));
    expectFault(file.filename().string());
    EXPECT_EQ(linesAbout(file.filename().string()), 1) << flown().log();
    const auto steps = flown().statistics().at("steps").get<std::int64_t>();
    ASSERT_TRUE(flown().waitFor([&](const json& s) { return s.at("steps").get<std::int64_t>() > steps; }))
        << "the flight goes on";
    writeTo(file, good);
    expectSound();
  }
}

TEST_F(LastGoodState, aBrokenPlayersFileChangesNothing) {
  fly();
  const fs::path file = flown().userFolder() / "settings.json";
  fs::create_directories(flown().userFolder());
  writeTo(file, R"({"schema": 1, "settings": {"view": {"hud": false,}}})");
  expectFault("settings.json");
  writeTo(file, R"({"schema": 1, "settings": {"view": {"camera": "cockpit"}}})");
  expectSound();
  EXPECT_TRUE(flown().waitFor([](const json& s) { return s.at("window").at("camera") == "cockpit"; }));
}

TEST_F(LastGoodState, aQualityWhosePresetIsBrokenIsNotTaken) {
  fly();
  ASSERT_EQ(flown().window().at("quality"), "low");
  const fs::path file = data() / "assets/presets/medium.json";
  const std::string good = contentOf(file);
  writeTo(file, "{\"schema\": 1, ");
  openMenu();
  enter("quality=medium");
  expectFault("medium.json");
  EXPECT_EQ(flown().window().at("quality"), "low");
  writeTo(file, good);
  enter("quality=medium");
  EXPECT_TRUE(flown().waitFor([](const json& s) { return s.at("window").at("quality") == "medium"; }));
  expectSound();
}

TEST_F(LastGoodState, aTierWhoseFileIsBrokenIsNotTakenNorKept) {
  fly({"--scene", "fair"});
  const fs::path file = data() / "assets/clouds/medium.json";
  const std::string good = contentOf(file);
  writeTo(file, "{\"schema\": 1, ");
  openMenu();
  enter("clouds.tier=medium");
  expectFault("clouds/medium.json");
  writeTo(file, good);
  enter("clouds.layers.0.coverage=0.25");  // another change, which is carried out
  expectSound();
  flown().process().askToEnd();
  ASSERT_EQ(flown().process().wait(60), 0) << flown().log();
  const json kept = json::parse(contentOf(flown().userFolder() / "settings.json")).at("settings");
  EXPECT_EQ(kept, json({{"clouds", {{"layers", {{"0", {{"coverage", 0.25}}}}}}}}))
      << "what was not taken is not kept";
}

TEST_F(LastGoodState, aSettingThatCallsForABrokenShaderIsTakenBack) {
  // The normals' shader is compiled when they are switched on: then the frame cannot be drawn.
  fly();
  const std::string name = "terrain/normals.geom";
  const fs::path file = data() / "shaders" / name;
  const std::string good = contentOf(file);
  writeTo(file, good + "\nthis is no shader\n");
  openMenu();
  enter("render.land.terrainNormals=true");
  expectFault(name);
  EXPECT_EQ(linesAbout(name), 1) << flown().log();
  EXPECT_FALSE(flown().statistics().at("passes").at("terrain").contains("skipped"));
  writeTo(file, good);
  const auto programs = flown().statistics().at("gl").at("programs").get<int>();
  enter("render.land.terrainNormals=true");
  ASSERT_TRUE(
      flown().waitFor([&](const json& s) { return s.at("gl").at("programs").get<int>() > programs; }));
  expectSound();
}

TEST_F(LastGoodState, newLandThatCannotBeMadeLeavesTheOldOne) {
  fly();
  const fs::path model = data() / "assets/models/airplane.glb";
  const std::string good = contentOf(model);
  writeTo(model, "broken");
  openMenu();
  enter("terrain.mountainWavelength=2000");
  expectFault("airplane.glb");
  const auto steps = flown().statistics().at("steps").get<std::int64_t>();
  ASSERT_TRUE(flown().waitFor([&](const json& s) { return s.at("steps").get<std::int64_t>() > steps; }));
  writeTo(model, good);
  enter("terrain.mountainWavelength=2000");
  ASSERT_TRUE(flown().waitFor([&](const json& s) { return s.at("steps").get<std::int64_t>() < steps; }))
      << "a new flight";
  expectSound();
}

TEST_F(LastGoodState, statisticsThatCannotBeWrittenEndNoFlightAndLoseNothingElse) {
  // A folder takes the place of the statistics file: the game goes on, and at the end the recording and the
  // player's settings are kept; the exit code says that something was lost.
  const fs::path record = data() / "flight.log";
  fly({"--record", record.string()});
  openMenu();
  enter("aircraft.rollFactor=0.5");
  ASSERT_TRUE(flown().waitFor([](const json&) { return true; }));
  const fs::path file = flown().statisticsFile();
  fs::remove(file);
  fs::create_directory(file);
  const core::Image picture = flown().screenshot();
  EXPECT_EQ(picture.width, FlownGame::kWidth) << "it goes on";
  flown().process().askToEnd();
  EXPECT_EQ(flown().process().wait(60), 1) << flown().log();
  EXPECT_NE(flown().log().find(file.string()), std::string::npos) << flown().log();
  EXPECT_TRUE(fs::is_regular_file(record));
  const json kept = json::parse(contentOf(flown().userFolder() / "settings.json")).at("settings");
  EXPECT_EQ(kept, json({{"aircraft", {{"rollFactor", 0.5}}}}));
}

}  // namespace
}  // namespace skydrop::test
