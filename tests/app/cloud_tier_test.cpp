#include "app/settings/cloud_tier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/session/run_config.h"
#include "skydrop/core/error.h"
#include "support/temporary_folder.h"

namespace skydrop::app {
namespace {

using clouds::CloudTier;

constexpr CloudTier kTiers[] = {CloudTier::off,  CloudTier::low,   CloudTier::medium,
                                CloudTier::high, CloudTier::ultra, CloudTier::reference};

CommandLine headless(std::vector<std::string> set = {}) {
  CommandLine line;
  line.verb = Verb::render;
  line.set = std::move(set);
  return line;
}

clouds::MarchSettings marchOf(CloudTier tier) {
  Settings settings;
  applyCloudTier(core::SettingsTable(settings), readCloudTier(cloudTierPath(tier)));
  return settings.clouds.march;
}

// Sets it as the menu does; the paths that changed with it.
std::vector<std::string> choose(RunConfig& run, const std::string& assignment) {
  core::setField(run.table, assignment);
  return takeMenuChanges(run, {assignment.substr(0, assignment.find('='))}).paths();
}

TEST(CloudTier, everyTierThatDrawsSaysEveryRowOfTheMarch) {
  // So a tier means the same whatever the defaults are; "off" draws nothing and says nothing.
  for (const CloudTier tier : kTiers) {
    const CloudTierFile file = readCloudTier(cloudTierPath(tier));
    EXPECT_FALSE(file.description.empty());
    const auto json = nlohmann::json::parse(file.settingsJson);
    if (tier == CloudTier::off) {
      EXPECT_TRUE(json.empty());
      continue;
    }
    Settings settings;
    const core::SettingsTable table(settings);
    for (const core::Field& field : table.fields()) {
      if (!belongsToCloudTier(field.path)) continue;
      EXPECT_TRUE(json["clouds"]["march"].contains(field.name)) << file.file << " " << field.path;
    }
  }
}

TEST(CloudTier, highIsTheDefaults) {
  Settings settings;
  const core::SettingsTable table(settings);
  applyCloudTier(table, readCloudTier(cloudTierPath(CloudTier::high)));
  EXPECT_EQ(core::toJson(table, true), nlohmann::json::object());
  EXPECT_EQ(settings.clouds.tier, CloudTier::high);
}

TEST(CloudTier, eachStepUpMarchesFiner) {
  for (std::size_t i = 2; i < std::size(kTiers); ++i) {
    const clouds::MarchSettings coarse = marchOf(kTiers[i - 1]), fine = marchOf(kTiers[i]);
    EXPECT_LT(fine.stepM, coarse.stepM);
    EXPECT_LT(fine.stepGrowth, coarse.stepGrowth);
    EXPECT_LE(fine.clearStride, coarse.clearStride);
    EXPECT_LE(fine.lightOpacity, coarse.lightOpacity);
    EXPECT_LT(fine.transmittanceCutoff, coarse.transmittanceCutoff);
    EXPECT_LT(fine.sunStepM, coarse.sunStepM);
    EXPECT_LT(fine.sunStepGrowth, coarse.sunStepGrowth);
    EXPECT_LT(fine.sunStepPerDepthM, coarse.sunStepPerDepthM);
    EXPECT_LE(fine.sunClearStride, coarse.sunClearStride);
    EXPECT_LT(fine.maxSegmentOpticalDepth, coarse.maxSegmentOpticalDepth);
    EXPECT_GE(fine.sunSamples, coarse.sunSamples);
    EXPECT_LE(fine.resolution, coarse.resolution);
    EXPECT_LT(fine.coarseTolerance, coarse.coarseTolerance);
    EXPECT_LT(fine.fineTolerance, coarse.fineTolerance);
    EXPECT_EQ(fine.exact, kTiers[i] == CloudTier::reference);
  }
}

TEST(CloudTier, theQualityChoosesItAndEveryOtherSourceLiesAbove) {
  // Tier, the quality's preset, scene, the player's file, --set; the tier itself may come from each of them.
  EXPECT_EQ(prepareRun(headless())->settings.clouds.tier, CloudTier::high);
  const auto low = prepareRun(headless({"quality=low"}));
  EXPECT_EQ(low->settings.clouds.tier, CloudTier::low);
  EXPECT_EQ(low->settings.clouds.march.stepM, marchOf(CloudTier::low).stepM);
  EXPECT_EQ(low->base.clouds.march.stepM, marchOf(CloudTier::low).stepM) << "what a reset goes back to";
  EXPECT_EQ(prepareRun(headless({"quality=medium"}))->settings.clouds.tier, CloudTier::medium);
  EXPECT_EQ(prepareRun(headless({"quality=ultra"}))->settings.clouds.tier, CloudTier::ultra);
  const auto chosen = prepareRun(headless({"quality=low", "clouds.tier=ultra", "clouds.march.stepM=7"}));
  EXPECT_EQ(chosen->settings.clouds.march.stepM, 7);
  EXPECT_EQ(chosen->settings.clouds.march.sunStepM, marchOf(CloudTier::ultra).sunStepM);

  const test::TemporaryFolder folder;
  CommandLine line = headless({"clouds.march.sunSamples=9"});
  line.scene = folder.write(
      "a.json",
      R"({"schema": 1, "settings": {"clouds": {"tier": "medium", "march": {"stepM": 21, "maxSegmentOpticalDepth": 2}}}})");
  folder.write("settings.json",
               R"({"schema": 1, "settings": {"clouds": {"march": {"maxSegmentOpticalDepth": 3}}}})");
  line.userDir = folder.path();
  const auto run = prepareRun(line);
  EXPECT_EQ(run->settings.clouds.march.sunStepM, marchOf(CloudTier::medium).sunStepM);
  EXPECT_EQ(run->settings.clouds.march.stepM, 21);
  EXPECT_EQ(run->settings.clouds.march.maxSegmentOpticalDepth, 3);
  EXPECT_EQ(run->settings.clouds.march.sunSamples, 9);
}

TEST(CloudTier, oneThatIsPickedInTheMenuTakesItsRowsAlong) {
  // The rows of the march follow, whatever they were set to; the weather stays; --set is heard no more.
  const auto run = prepareRun(headless({"clouds.march.stepM=9"}));
  choose(*run, "clouds.layers.0.coverage=0.8");
  choose(*run, "clouds.march.maxSegmentOpticalDepth=1.5");
  const std::vector<std::string> changed = choose(*run, "clouds.tier=low");
  EXPECT_EQ(run->settings.clouds.march.stepM, marchOf(CloudTier::low).stepM);
  EXPECT_EQ(run->settings.clouds.march.maxSegmentOpticalDepth,
            marchOf(CloudTier::low).maxSegmentOpticalDepth);
  EXPECT_EQ(run->settings.clouds.layers[0].coverage, 0.8);
  for (const char* path : {"clouds.tier", "clouds.march.stepM", "clouds.march.maxSegmentOpticalDepth"}) {
    EXPECT_EQ(std::count(changed.begin(), changed.end(), path), 1) << path;
  }
  EXPECT_EQ(std::count(changed.begin(), changed.end(), "clouds.layers.0.coverage"), 0);
  EXPECT_TRUE(run->table.at("clouds.march.stepM").isDefault());
  // The way back, as undo takes it: the value of before, as another change.
  choose(*run, "clouds.tier=high");
  EXPECT_EQ(run->settings.clouds.march.stepM, marchOf(CloudTier::high).stepM);
  // A quality brings its tier, and the tier its rows.
  choose(*run, "clouds.tier=reference");
  choose(*run, "quality=medium");
  EXPECT_EQ(run->settings.clouds.tier, CloudTier::medium);
  EXPECT_EQ(run->settings.clouds.march.stepM, marchOf(CloudTier::medium).stepM);
}

TEST(CloudTier, rowsChosenTogetherWithATierStay) {
  // A preset of the player's may hold a tier and a row of its own; a reset of everything is one too.
  const auto run = prepareRun(headless());
  core::setField(run->table, "clouds.tier=low");
  core::setField(run->table, "clouds.march.stepM=33");
  takeMenuChanges(*run, {"clouds.tier", "clouds.march.stepM"});
  EXPECT_EQ(run->settings.clouds.march.stepM, 33);
  EXPECT_EQ(run->settings.clouds.march.sunStepM, marchOf(CloudTier::low).sunStepM);
  for (const char* path : {"clouds.tier", "clouds.march.stepM"}) run->table.at(path).reset();
  takeMenuChanges(*run, {"clouds.tier", "clouds.march.stepM"});
  EXPECT_EQ(run->settings.clouds.tier, CloudTier::high);
  EXPECT_EQ(run->settings.clouds.march.stepM, marchOf(CloudTier::high).stepM);
}

TEST(CloudTier, aBadFileIsRefusedInOneLineThatNamesFileAndField) {
  const test::TemporaryFolder folder;
  const auto refusalOf = [&](const std::string& text) {
    const std::string file = folder.write("tier.json", text);
    try {
      Settings settings;
      applyCloudTier(core::SettingsTable(settings), readCloudTier(file));
    } catch (const core::DataError& error) {
      const std::string line = error.what();
      EXPECT_EQ(line.find('\n'), std::string::npos) << line;
      EXPECT_TRUE(line.starts_with(file + ": ")) << line;
      return line.substr(file.size() + 2);
    }
    ADD_FAILURE() << "taken: " << text;
    return std::string();
  };
  const auto withSettings = [](const std::string& settings) {
    return R"({"schema": 1, "description": "d", "settings": )" + settings + "}";
  };
  EXPECT_TRUE(refusalOf("{").starts_with("line 1, column 1"));
  EXPECT_TRUE(refusalOf(R"({"schema": 9})").starts_with("schema"));
  EXPECT_TRUE(refusalOf(R"({"schema": 1})").starts_with("description"));
  EXPECT_TRUE(refusalOf(R"({"schema": 1, "description": "d", "window": []})").starts_with("window"));
  EXPECT_TRUE(refusalOf(withSettings("[]")).starts_with("settings"));
  EXPECT_TRUE(refusalOf(withSettings(R"({"render": {}})")).starts_with("render"));
  EXPECT_TRUE(refusalOf(withSettings(R"({"clouds": {"tier": "low"}})")).starts_with("clouds.tier"));
  EXPECT_TRUE(refusalOf(withSettings(R"({"clouds": {"coverage": 1}})")).starts_with("clouds.coverage"));
  EXPECT_TRUE(refusalOf(withSettings(R"({"clouds": 3})")).starts_with("clouds"));
  EXPECT_TRUE(
      refusalOf(withSettings(R"({"clouds": {"march": {"stepM": 0}}})")).starts_with("clouds.march.stepM"));
  EXPECT_TRUE(
      refusalOf(withSettings(R"({"clouds": {"march": {"steps": 5}}})")).starts_with("clouds.march.steps"));
}

}  // namespace
}  // namespace skydrop::app
