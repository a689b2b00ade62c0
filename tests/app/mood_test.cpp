// Moods of the sky: what they set, what comes before and after them, and how one is picked.
#include "app/settings/mood.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "app/session/run_config.h"
#include "skydrop/core/error.h"
#include "skydrop/render/frame/sky_clock.h"
#include "skydrop/render/frame/sky_light.h"
#include "skydrop/sky/almanac.h"
#include "support/refusal.h"
#include "support/temporary_folder.h"

namespace skydrop::app {
namespace {

CommandLine headless(std::vector<std::string> set = {}) {
  CommandLine line;
  line.verb = Verb::render;
  line.scene = "fair";
  line.set = std::move(set);
  return line;
}

Settings in(Mood mood) {
  Settings settings;
  applyMood(core::SettingsTable(settings), mood);
  return settings;
}

double sunElevation(const Settings& settings) {
  return sky::sunAt(render::clockDays(settings.render.sun, 0), render::placeOf(settings.render.sun))
      .horizontal.elevationDegrees;
}

TEST(Mood, eachIsWhatItsNameSays) {
  // The sun where the time of day has it; the moon near full and up in the moonlit night, down in the starry
  // one.
  struct Row {
    Mood mood;
    double lowest, highest;
  };
  for (const Row& row : {Row{Mood::dawn, -1, 4}, Row{Mood::morning, 8, 30}, Row{Mood::noon, 55, 90},
                         Row{Mood::afternoon, 25, 50}, Row{Mood::goldenSunset, 2, 7}, Row{Mood::dusk, -6, -2},
                         Row{Mood::moonlitNight, -90, -18}, Row{Mood::starryNight, -90, -18}}) {
    const Settings settings = in(row.mood);
    const double elevation = sunElevation(settings);
    EXPECT_EQ(settings.render.sun.source, render::SunSource::clock);
    EXPECT_GE(elevation, row.lowest) << static_cast<int>(row.mood);
    EXPECT_LE(elevation, row.highest) << static_cast<int>(row.mood);
  }
  const auto moonOf = [](const Settings& settings) {
    return sky::moonAt(render::clockDays(settings.render.sun, 0), render::placeOf(settings.render.sun));
  };
  const Settings moonlit = in(Mood::moonlitNight), starry = in(Mood::starryNight);
  EXPECT_GT(moonOf(moonlit).horizontal.elevationDegrees, 12);
  EXPECT_TRUE(render::skyLight(moonlit.render, 300).moon.has_value());
  EXPECT_FALSE(render::skyLight(starry.render, 300).moon.has_value());
}

TEST(Mood, theyLeaveTheSimulationAloneAndSetTheSameRows) {
  // So that no row of one stays when another is picked. The cloud layer alone decides what is flown through
  // where a scene has weather.
  std::set<std::string> all;
  for (const std::string& path : moodPaths()) {
    EXPECT_TRUE(!decidesSimulation(path) || path.starts_with("clouds.layers.")) << path;
    all.insert(path);
  }
  EXPECT_GE(all.size(), 8u);
  EXPECT_FALSE(all.contains("sky.mood"));
  EXPECT_EQ(in(Mood::none).render.sun.source, Settings().render.sun.source);
}

TEST(Mood, whatIsSetAfterItWins) {
  // A row of --set, whatever its place in the line; and the mood of --set over rows of the scene.
  const auto run = prepareRun(headless({"sky.latitude=10", "sky.mood=dusk", "clouds.layers.0.coverage=0.7"}));
  EXPECT_EQ(run->settings.sky.mood, Mood::dusk);
  EXPECT_EQ(run->settings.render.sun.latitudeDegrees, 10);
  EXPECT_EQ(run->settings.clouds.layers[0].coverage, 0.7);
  EXPECT_EQ(run->settings.render.sun.utcMs, in(Mood::dusk).render.sun.utcMs);
  EXPECT_EQ(prepareRun(headless())->settings.sky.mood, Mood::none);
}

TEST(Mood, aScenesOwnRowsLieAboveTheMoodThatItNamesAndBelowAnotherOne) {
  const test::TemporaryFolder folder;
  const std::string file = folder.write("own.json", R"({"schema": 1, "description": "d", "effects": ["sky"],
      "settings": {"sky": {"mood": "dawn"}, "render": {"sun": {"latitudeDegrees": 20}}}})");
  CommandLine line = headless();
  line.scene = file;
  const auto own = prepareRun(line);
  EXPECT_EQ(own->settings.sky.mood, Mood::dawn);
  EXPECT_EQ(own->settings.render.sun.latitudeDegrees, 20);
  EXPECT_EQ(own->settings.render.sun.utcMs, in(Mood::dawn).render.sun.utcMs);
  line.set = {"sky.mood=noon"};
  const auto other = prepareRun(line);
  EXPECT_EQ(other->settings.render.sun.latitudeDegrees, in(Mood::noon).render.sun.latitudeDegrees);
  EXPECT_EQ(other->settings.render.sun.utcMs, in(Mood::noon).render.sun.utcMs);
}

TEST(Mood, pickedInTheMenuItTakesItsRowsAlong) {
  // Whatever they were set to before; another one takes them again, and none gives them back to the scene.
  const auto run = prepareRun(headless({"sky.latitude=10"}));
  const auto pick = [&](Mood mood) {
    run->settings.sky.mood = mood;
    return takeMenuChanges(*run, {std::string(kMoodRow)});
  };
  EXPECT_TRUE(pick(Mood::goldenSunset).touches("render.sun.utc"));
  EXPECT_EQ(run->settings.render.sun.latitudeDegrees, in(Mood::goldenSunset).render.sun.latitudeDegrees);
  run->settings.render.sun.utcMs = 0;
  takeMenuChanges(*run, {"render.sun.utc"});
  EXPECT_EQ(run->settings.render.sun.utcMs, 0) << "a row that is set after it stays";
  pick(Mood::noon);
  EXPECT_EQ(run->settings.render.sun.utcMs, in(Mood::noon).render.sun.utcMs);
  pick(Mood::none);
  EXPECT_EQ(run->settings.render.sun.source, render::SunSource::manual);
  EXPECT_EQ(run->settings.clouds.layers[0].coverage,
            prepareRun(headless())->settings.clouds.layers[0].coverage);
}

TEST(Mood, anUnknownOneIsRefusedInOneLineWithTheNames) {
  const std::string line =
      test::refusalOf<core::UsageError>([] { prepareRun(headless({"sky.mood=twilight"})); });
  EXPECT_EQ(line.find('\n'), std::string::npos);
  for (const std::string_view name : kMoodNames) EXPECT_NE(line.find(name), std::string::npos) << line;
}

}  // namespace
}  // namespace skydrop::app
