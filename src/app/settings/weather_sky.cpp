#include "app/settings/weather_sky.h"

#include <algorithm>
#include <array>

#include "app/settings/settings.h"
#include "skydrop/core/json.h"
#include "skydrop/core/settings_file.h"
#include "skydrop/scene/scene.h"

namespace skydrop::app {
namespace {

// In the order of weather::SkyChoice, from its second on.
constexpr std::array<std::string_view, 5> kScenes = {"breeze", "warmFront", "coldFront", "thunderstorm",
                                                     "afterRain"};
static_assert(kScenes.size() + 1 == weather::kSkyChoiceNames.size());

// How strongly the air is felt is the player's business.
constexpr std::array<std::string_view, 7> kOfASky = {"weather.variability",
                                                     "weather.wanderSeconds",
                                                     "weather.secondSite",
                                                     "weather.approachSeconds",
                                                     "weather.sites.",
                                                     "clouds.layers.0.",
                                                     "wind."};

bool isOfASky(const std::string& path) {
  return std::ranges::any_of(kOfASky, [&](std::string_view rows) { return path.starts_with(rows); });
}

}  // namespace

void applyWeatherSky(const core::SettingsTable& table, weather::SkyChoice sky) {
  if (sky == weather::SkyChoice::none) return;
  Settings ofScene;
  const core::SettingsTable from(ofScene);
  const scene::Scene scene = scene::loadScene(kScenes[static_cast<std::size_t>(sky) - 1]);
  core::applyJson(from, core::parseJson(scene.settingsJson, scene.file.string()), scene.file.string());
  for (const std::string& path : weatherSkyPaths(table)) table.at(path).set(from.at(path).get());
}

std::vector<std::string> weatherSkyPaths(const core::SettingsTable& table) {
  std::vector<std::string> paths;
  for (const core::Field& field : table.fields()) {
    if (isOfASky(field.path) && field.path != "wind.movesAircraft") paths.push_back(field.path);
  }
  return paths;
}

}  // namespace skydrop::app
