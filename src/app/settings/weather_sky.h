// Skies as data: each is the weather of a shipped scene, for any other scene. A sky is a value that sets
// other rows, as a mood is (mood.h), and lies where a mood lies: named by a scene below the scene's own rows;
// chosen by the player or on the command line above these. What the player and --set say of single rows comes
// later in either case.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "skydrop/core/settings_table.h"
#include "skydrop/weather/weather_settings.h"

namespace skydrop::app {

// The row that picks a sky.
inline constexpr std::string_view kWeatherSkyRow = "weather.sky";

// Puts the rows of sites and change of the weather, of the wind and of the low clouds to their defaults, and
// then to what the sky's scene has, of a table of app::Settings; of none nothing. The low clouds stay at the
// defaults, with which they change nothing in the weather's low layer. Throws core::DataError where the
// scene's file is broken.
void applyWeatherSky(const core::SettingsTable& table, weather::SkyChoice sky);

// The paths that a sky sets: the rows that follow when one is picked.
std::vector<std::string> weatherSkyPaths(const core::SettingsTable& table);

}  // namespace skydrop::app
