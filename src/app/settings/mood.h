// Moods of the sky as data: assets/moods/NAME.json holds the rows of sun, air, clouds and stars that make
// one. A mood is a value that sets other rows, as a tier of the clouds is (cloud_tier.h). Named by a scene it
// lies below the scene's own rows; chosen by the player or on the command line it lies above these. What the
// player and --set say of single rows comes later in either case.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "skydrop/core/settings.h"
#include "skydrop/core/settings_table.h"

namespace skydrop::app {

enum class Mood {
  none,  // every row for itself
  dawn,
  morning,
  noon,
  afternoon,
  goldenSunset,
  dusk,
  moonlitNight,
  starryNight
};
inline constexpr std::array<std::string_view, 9> kMoodNames = {
    "none", "dawn", "morning", "noon", "afternoon", "goldenSunset", "dusk", "moonlitNight", "starryNight"};

struct MoodSettings {
  Mood mood = Mood::none;

  bool operator==(const MoodSettings&) const = default;
};

void describe(core::SettingsVisitor& visitor, MoodSettings& settings);

// The row that picks a mood.
inline constexpr std::string_view kMoodRow = "sky.mood";

// Sets the rows of the mood's file, of a table of app::Settings; of none nothing. Throws core::DataError
// where the file is broken or sets a row that is no mood's business, and then changes nothing.
void applyMood(const core::SettingsTable& table, Mood mood);

// The paths that some mood sets: the rows that follow when one is picked. Throws core::DataError.
std::vector<std::string> moodPaths();

}  // namespace skydrop::app
