// The files that the land of a run is made of: heights, and aerial images that it wears.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/settings/settings.h"
#include "app/types/command_line.h"
#include "skydrop/core/settings_table.h"
#include "skydrop/elevation/aerial_image.h"
#include "skydrop/elevation/raster.h"
#include "skydrop/game/input_log.h"
#include "skydrop/scene/scene.h"

namespace skydrop::app {

struct LandFiles {
  std::vector<std::shared_ptr<const elevation::Raster>> elevation;  // empty: endless land
  std::vector<game::InputLog::WeatherRecord> records;               // of those, for the log
  std::vector<std::shared_ptr<const elevation::AerialImage>> images;
};

// Those of the command line, else of the scene; heights in a replay those that it was flown over (`log`, from
// the file of that name). Throws core::DataError.
LandFiles openLandFiles(const CommandLine& line, const scene::Scene& scene, const game::InputLog* log,
                        const std::string& logFile);

// What openLandFiles reads without a log, and what may lie beside it (world files, reference systems):
// whoever writes one of them changes the land.
std::vector<std::filesystem::path> filesOfLand(const CommandLine& line, const scene::Scene& scene);

// Whether another scene brings other files, as far as the command line does not.
bool namesOtherLand(const CommandLine& line, const scene::Scene& before, const scene::Scene& after);

// Assignments (--set) of the world's origin and of the place whose sky it is, which follow the files unless
// the settings, which the table is of, already say otherwise. None without files.
std::vector<std::string> rowsOfLand(const LandFiles& files, const Settings& settings,
                                    const core::SettingsTable& table);

}  // namespace skydrop::app
