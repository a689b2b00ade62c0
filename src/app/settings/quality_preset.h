// The qualities of the picture as data: assets/presets/NAME.json holds the settings that differ from the
// defaults, and the size in which a window opens. Settings that decide the simulation have no place in one.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/settings/settings.h"
#include "app/types/size.h"

namespace skydrop::app {

struct QualityPreset {
  std::string description;
  Size window;  // in which the game opens unless told or remembered otherwise
  std::string file;
  std::string settingsJson;
};

// The quality that `chosen` comes to: automatic is low where a software renderer draws, else high. Headless
// runs pass false: what they draw must not depend on the machine.
Quality qualityFor(Quality chosen, bool softwareRenderer);

// Of low .. ultra, or any file of the form. Throws core::DataError; what the settings say is judged by
// applyPreset().
QualityPreset readQualityPreset(Quality quality);
QualityPreset readQualityPreset(const std::filesystem::path& file);

// Throws core::DataError, and then changes nothing.
void applyPreset(const core::SettingsTable& table, const QualityPreset& preset);

// The paths that some preset sets: the rows that follow when the player picks a quality. Throws
// core::DataError.
std::vector<std::string> presetPaths();

}  // namespace skydrop::app
