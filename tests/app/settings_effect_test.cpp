// Every row of the menu does something over all that its slider covers. Here the rows of flight, game, land,
// streaming, sound, view and input, by what the simulation, the land, the loudspeaker or the interface makes
// of them; rows of the picture in tests/gl/settings_effect_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "app/settings_probes.h"
#include "skydrop/audio/audio_manager.h"
#include "skydrop/core/settings_table.h"
#include "support/row_steps.h"

namespace skydrop::app {
namespace {

// Not tried here, but where it says.
constexpr std::string_view kElsewhere[] = {
    "streaming.farDistanceM",  // tests/gl/settings_effect_test.cpp
    "view.frameCapHz",         // FrameSchedule, FramePacer: tests/app/frame_pacer_test.cpp
    "view.frameBudgetMs",      // FrameBudget: tests/app/frame_budget_test.cpp
    "view.vsync",              // the driver's: no picture, no state
    "view.freezeTime",         // tests/window/comfort_test.cpp
    "view.eyeAdaptation",      // of frames that follow others: tests/gl/night_flight_test.cpp
    "live.renewMinutes",       // forecast::Renewal: tests/app/renewal_test.cpp
    "aerialImage.megatexels",  // tests/unit/aerial_image_test.cpp
    "view.dropView",           // tests/window/delivery_test.cpp
    "view.briefing",           // tests/window/delivery_test.cpp
    "view.lesson",             // tests/window/delivery_test.cpp
    "view.weatherBar",         // tests/ui/weather_bar_test.cpp
    "view.split.",             // tests/gl/split_view_test.cpp
    "render.",                 // all but the camera: tests/gl/settings_effect_test.cpp
    "clouds.",                 // tests/gl/settings_effect_test.cpp
    "cloudPlanes.",            // tests/gl/settings_effect_test.cpp
    "cloudDome.",              // tests/gl/settings_effect_test.cpp
    "groundFog.",              // tests/gl/ground_fog_test.cpp
    "stars.",                  // tests/gl/night_sky_test.cpp
    "landShadows.",            // tests/gl/land_shadows_test.cpp
    "lightShafts.",            // tests/gl/light_shafts_test.cpp
    "aircraftLights.",         // tests/gl/night_flight_test.cpp
    "landingLight.",           // tests/gl/night_flight_test.cpp
    "sky.",                    // tests/app/mood_test.cpp
    "woods.obstacles",         // tests/app/tree_flight_test.cpp
    "villages.obstacles",      // tests/app/house_flight_test.cpp
    "vegetation.",             // tests/gl/vegetation_test.cpp
    "places.",                 // tests/gl/places_test.cpp
    "groundDetail.",           // tests/gl/ground_detail_test.cpp
    "waterDetail.",            // tests/gl/water_detail_test.cpp
    "dustAndSpray.",           // tests/gl/dust_and_spray_test.cpp
    "groundCover.",            // tests/gl/ground_cover_test.cpp
};

// Of the tries here, not of the rows: what a budget has room for once everything is there.
constexpr test::IdlePart kIdleParts[] = {
    {"game.targetSlopeDeg", 27, 45, "land as steep as that is rare among 30 targets"},
    {"autopilot.maxBankDeg", 10, 35, "the target of this flight lies nearly ahead"},
    {"autopilot.dropMargin", 0, 0.15, "the first drop of this flight is nearer than that"},
    {"strips.density", 0.4, 0.5, "none of the squares that are looked at lies between"},
    {"gear.mostSideLoad", 0.1, 1.6, "tests/unit/ground_handling_test.cpp"},
    {"gear.mostWaterSpeed", 5, 90, "arrivals as slow or as fast as that break or float alike"},
    {"streaming.seaFloorDepthM", 30, 45, "no patch of this view ends between"},
    {"streaming.seaFloorDepthM", 135, 150, "no patch of this view ends between"},
    {"streaming.cacheMiB", 27, 4096, "there is no more land in the five views"},
    {"streaming.gpuMiB", 24, 128, "the view wants no more"},
    {"streaming.uploadMiBPerFrame", 19, 128, "the view wants no more"},
    {"streaming.texelPixels", 3.9, 8.1, "the mesh of this view asks for as fine samples by itself"},
    {"streaming.queueLimit", 128, 1024, "the view wants no more"},
};

bool startsWithAny(std::string_view path, std::span<const std::string_view> beginnings) {
  return std::ranges::any_of(beginnings,
                             [&](std::string_view beginning) { return path.starts_with(beginning); });
}

class SettingsEffect : public testing::TestWithParam<const char*> {};

TEST_P(SettingsEffect, everyTenthOfEveryRowMakesADifference) {
  if (std::string_view(GetParam()) == "audio.") {
    try {
      audio::AudioManager(audio::AudioSettings(), audio::AudioManager::Output::loopback);
    } catch (const std::runtime_error& error) {
      GTEST_SKIP() << error.what();
    }
  }
  Settings settings;
  const core::SettingsTable table(settings);
  int rows = 0;
  for (const core::Field& field : table.fields()) {
    if (!field.path.starts_with(GetParam())) continue;
    if (field.path == "weather.sky") continue;  // tests/app/weather_sky_test.cpp
    const auto probe = std::ranges::find_if(settingsProbes(),
                                            [&](const Probe& p) { return field.path.starts_with(p.rows); });
    if (probe == settingsProbes().end()) {
      EXPECT_TRUE(startsWithAny(field.path, kElsewhere)) << field.path << ": nobody has tried this row";
      continue;
    }
    ++rows;
    settings = Settings();
    for (const std::string& given : probe->given) core::setField(table, given);
    for (const std::string& line :
         test::idleSteps(field, kIdleParts, [&] { return probe->observe(settings); }))
      ADD_FAILURE() << line;
  }
  EXPECT_GT(rows, 0);
}

constexpr const char* kGroups[] = {"gear.",    "strips.",    "woods.",       "villages.",  "aircraft.",
                                   "package.", "game.",      "delivery.",    "assist.",    "autopilot.",
                                   "terrain.", "elevation.", "aerialImage.", "streaming.", "audio.",
                                   "view.",    "input.",     "quality",      "clouds.",    "render.",
                                   "wind.",    "weather.",   "weatherFile.", "lightning.", "live."};
// Tried by tests/gl/settings_effect_test.cpp alone.
constexpr const char* kGroupsOfPictures[] = {
    "cloudPlanes.", "cloudDome.", "groundFog.",     "stars.",          "landShadows.",
    "halo.",        "rainbow.",   "lightShafts.",   "aircraftLights.", "landingLight.",
    "sky.",         "iceClouds.", "precipitation.", "vegetation.",     "groundDetail.",
    "waterDetail.", "places.",    "dustAndSpray.",  "groundCover."};

INSTANTIATE_TEST_SUITE_P(Groups, SettingsEffect, testing::ValuesIn(kGroups), [](const auto& group) {
  std::string name = group.param;
  std::erase(name, '.');
  return name;
});

TEST(SettingsEffectOfAll, everyGroupIsTried) {
  Settings settings;
  const core::SettingsTable table(settings);
  for (const core::Field& field : table.fields()) {
    const bool isTried =
        std::ranges::any_of(kGroups, [&](const char* group) { return field.path.starts_with(group); }) ||
        std::ranges::any_of(kGroupsOfPictures,
                            [&](const char* group) { return field.path.starts_with(group); });
    // The switches of the effects are tried in tests/gl/effects_test.cpp.
    EXPECT_TRUE(isTried || field.path.starts_with("effects.")) << field.path;
  }
}

}  // namespace
}  // namespace skydrop::app
