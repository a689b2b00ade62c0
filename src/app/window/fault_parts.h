#pragma once

#include <string_view>

namespace skydrop::app::part {

// Parts of the program whose faults stand until they are repaired.
inline constexpr std::string_view kStart = "start", kShaders = "shaders", kScene = "scene",
                                  kPlayersFile = "player's file", kPlayersValues = "player's values",
                                  kChange = "change", kPreset = "preset", kFrame = "frame",
                                  kStatistics = "statistics", kScreenshot = "screenshot",
                                  kChoices = "choices", kWeather = "weather", kLand = "land";

}  // namespace skydrop::app::part
