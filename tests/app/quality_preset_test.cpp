#include "app/settings/quality_preset.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/session/run_config.h"
#include "skydrop/core/error.h"
#include "support/refusal.h"
#include "support/temporary_folder.h"

namespace skydrop::app {
namespace {

constexpr Quality kPresets[] = {Quality::low, Quality::medium, Quality::high, Quality::ultra};

CommandLine headless(std::vector<std::string> set = {}) {
  CommandLine line;
  line.verb = Verb::render;
  line.set = std::move(set);
  return line;
}

std::unique_ptr<RunConfig> inSoftware(const CommandLine& line) {
  auto run = prepareRun(line);
  useSoftwareRenderer(*run);
  return run;
}

TEST(QualityPreset, everyPresetIsAppliedWholeAndLeavesTheSimulationAlone) {
  // Same flight, same hash, whatever the quality; and each step up asks for finer land.
  double coarser = 1e9;
  for (const Quality quality : kPresets) {
    const QualityPreset preset = readQualityPreset(quality);
    EXPECT_FALSE(preset.description.empty());
    EXPECT_GE(preset.window.width, 320);
    Settings settings;
    applyPreset(core::SettingsTable(settings), preset);
    EXPECT_LT(settings.streaming.pixelError, coarser);
    coarser = settings.streaming.pixelError;
  }
  EXPECT_FALSE(presetPaths().empty());
  for (const std::string& path : presetPaths()) EXPECT_FALSE(decidesSimulation(path)) << path;
}

TEST(QualityPreset, aBadFileIsRefusedInOneLineThatNamesFileAndMember) {
  // A window of no size would be asked of the window system, which prints errors of its own.
  const test::TemporaryFolder folder;
  const auto refusalOf = [&](const std::string& window, const std::string& more) {
    const std::string file =
        folder.write("low.json", R"({"schema": 1, "description": "d", "window": )" + window + more + "}");
    const std::string line = test::refusalOf<core::DataError>([&] {
      Settings settings;
      applyPreset(core::SettingsTable(settings), readQualityPreset(std::filesystem::path(file)));
    });
    return line.empty() ? line : line.substr(std::min(line.size(), file.size() + 2));
  };
  EXPECT_EQ(refusalOf("[640, 360]", ""), "");
  EXPECT_EQ(refusalOf("[0, 0]", ""), "window: 0 is out of range 1.0 to 16384.0");
  EXPECT_EQ(refusalOf("[640, -360]", ""), "window: -360 is out of range 1.0 to 16384.0");
  EXPECT_EQ(refusalOf("[640, 1e10]", ""), "window: 10000000000.0 is out of range 1.0 to 16384.0");
  EXPECT_EQ(refusalOf("[640.5, 360]", ""), "window: 640.5 is not a whole number");
  for (const char* window : {"[640]", "[640, 360, 1]", "640", "{}", "null"})
    EXPECT_EQ(refusalOf(window, ""), "window: is not a list of width and height") << window;
  EXPECT_EQ(refusalOf("[640, 360]", R"(, "wings": 2)"), "wings: unknown member");
  EXPECT_EQ(refusalOf("[640, 360]", R"(, "settings": {"streaming": {"pixelError": -1}})").substr(0, 24),
            "streaming.pixelError: -1");
  EXPECT_EQ(refusalOf("[640, 360]", R"(, "settings": {"aircraft": {"mass": 900}})"),
            "aircraft.mass: a quality leaves the simulation alone");
}

TEST(QualityPreset, highIsTheDefaults) {
  Settings settings;
  const core::SettingsTable table(settings);
  applyPreset(table, readQualityPreset(Quality::high));
  EXPECT_EQ(core::toJson(table, true), nlohmann::json::object());
}

TEST(QualityPreset, automaticGoesByTheRendererAndHeadlessRunsDoNot) {
  EXPECT_EQ(prepareRun(headless())->quality, Quality::high);
  EXPECT_EQ(inSoftware(headless())->quality, Quality::low);
  EXPECT_EQ(inSoftware(headless({"quality=ultra"}))->quality, Quality::ultra) << "a choice wins";
  EXPECT_EQ(prepareRun(headless({"quality=medium"}))->settings.streaming.pixelError, 3);
}

TEST(QualityPreset, everyOtherSourceLiesAboveThePreset) {
  // Preset, then scene, then the player's file, then --set; the quality itself may come from each of them.
  const test::TemporaryFolder folder;
  CommandLine line = headless({"streaming.cellPixels=60"});
  line.scene = folder.write("a.json", R"({"schema": 1, "settings": {"streaming": {"viewDistanceM": 5000}}})");
  folder.write("settings.json",
               R"({"schema": 1, "settings": {"streaming": {"texelPixels": 5}, "quality": "ultra"}})");
  line.userDir = folder.path();
  const auto run = inSoftware(line);
  EXPECT_EQ(run->quality, Quality::ultra);
  EXPECT_EQ(run->settings.streaming.pixelError, 1);
  EXPECT_EQ(run->settings.streaming.viewDistanceM, 5000);
  EXPECT_EQ(run->settings.streaming.texelPixels, 5);
  EXPECT_EQ(run->settings.streaming.cellPixels, 60);
}

TEST(QualityPreset, oneThatIsPickedInTheMenuTakesItsRowsAlong) {
  // Rows of presets follow, whatever they were set to; all other choices stay; --set is heard no more.
  const auto run = prepareRun(headless({"streaming.pixelError=9", "quality=medium"}));
  const auto choose = [&](const char* assignment) {
    core::setField(run->table, assignment);
    const std::string text(assignment);
    return takeMenuChanges(*run, {text.substr(0, text.find('='))}).paths();
  };
  choose("aircraft.yawSpeed=40");
  choose("streaming.texelPixels=7");
  const std::vector<std::string> changed = choose("quality=ultra");
  EXPECT_EQ(run->settings.streaming.pixelError, 1);
  EXPECT_EQ(run->settings.streaming.texelPixels, 1);
  EXPECT_EQ(run->settings.aircraft.yawSpeed, 40);
  for (const char* path : {"quality", "streaming.pixelError", "streaming.texelPixels"}) {
    EXPECT_EQ(std::count(changed.begin(), changed.end(), path), 1) << path;
  }
  EXPECT_EQ(std::count(changed.begin(), changed.end(), "aircraft.yawSpeed"), 0);
}

TEST(QualityPreset, aResetGoesBackToThePreset) {
  const auto run = prepareRun(headless({"quality=low"}));
  const core::Field& field = run->table.at("streaming.pixelError");
  EXPECT_TRUE(field.isDefault());
  core::setField(field, 1.0);
  field.reset();
  EXPECT_EQ(run->settings.streaming.pixelError, 4);
}

}  // namespace
}  // namespace skydrop::app
