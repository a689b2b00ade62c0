#include "app/settings/settings_change.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "app/settings/settings.h"

namespace skydrop::app {
namespace {

using Paths = std::vector<std::string>;

TEST(SettingsChange, touchesAFieldItsGroupAndTheGroupsAbove) {
  const SettingsChange change{"clouds.march.stepM", "quality"};
  for (const char* touched : {"clouds", "clouds.march", "clouds.march.stepM", "quality"}) {
    EXPECT_TRUE(change.touches(touched)) << touched;
  }
  for (const char* other : {"cloud", "clouds.layers", "clouds.march.step", "clouds.march.stepM.x", "wind"}) {
    EXPECT_FALSE(change.touches(other)) << other;
  }
  EXPECT_FALSE(SettingsChange().touches("clouds"));
  EXPECT_TRUE(change.touches("")) << "everyone";
  EXPECT_FALSE(SettingsChange().touches(""));
}

TEST(SettingsChange, isWhatDiffersBetweenTwoStates) {
  Settings before, now;
  const core::SettingsTable beforeTable(before), nowTable(now);
  EXPECT_TRUE(SettingsChange::between(beforeTable, nowTable).empty());
  now.wind.speed = 30;
  now.clouds.layers[0].coverage = 1;
  EXPECT_EQ(SettingsChange::between(beforeTable, nowTable).paths(),
            (Paths{"clouds.layers.0.coverage", "wind.speed"}));
}

TEST(SettingsChange, eachPathCountsOnce) {
  SettingsChange change{"wind.speed", "quality", "wind.speed"};
  change.add(SettingsChange{"quality", "view.hud"});
  EXPECT_EQ(change.paths(), (Paths{"wind.speed", "quality", "view.hud"}));
}

TEST(SettingsChange, theDescriptionSaysHowItTakesEffect) {
  // The land alone, of noise or of elevation data, with strips or without, needs the flight to be loaded
  // again; nothing of the weather does.
  Settings settings;
  const core::SettingsTable table(settings);
  for (const core::Field& field : table.fields()) {
    const bool reloads = SettingsChange{field.path}.needs(core::TakesEffect::restart, table);
    EXPECT_EQ(reloads, field.group == "terrain" || field.group == "elevation" || field.group == "strips")
        << field.path;
  }
  const SettingsChange land{"view.hud", "terrain.landBias"};
  EXPECT_TRUE(land.needs(core::TakesEffect::restart, table));
}

TEST(SettingsDependencies, thoseThatAChangeTouchesHearOfItOnceAndInOrder) {
  SettingsDependencies dependencies;
  Paths heard;
  const auto add = [&](const char* name, std::vector<std::string> paths) {
    dependencies.add(std::move(paths), [&heard, name](const SettingsChange&) { heard.emplace_back(name); });
  };
  add("sky", {"clouds", "wind"});
  add("flight", {"aircraft", "wind"});
  add("sound", {"audio"});
  dependencies.apply({"wind.speed", "clouds.tier"});
  EXPECT_EQ(heard, (Paths{"sky", "flight"}));
  heard.clear();
  dependencies.apply({"audio.mute"});
  EXPECT_EQ(heard, Paths{"sound"});
  heard.clear();
  dependencies.apply({"view.hud"});
  dependencies.apply({});
  EXPECT_TRUE(heard.empty());
}

}  // namespace
}  // namespace skydrop::app
