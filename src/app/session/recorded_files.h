// What a log keeps of files that a flight goes by, weather and land.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "skydrop/game/input_log.h"

namespace skydrop::app {

using FileRecords = std::vector<game::InputLog::WeatherRecord>;

// Throws core::DataError in a replay, where they are not those that were `flown`; `log` names it.
FileRecords recordsOf(const std::vector<std::filesystem::path>& files,
                      const std::vector<std::uint64_t>& digests, const FileRecords* flown,
                      const std::string& log);

std::vector<std::filesystem::path> sourcesOf(const FileRecords& records);

}  // namespace skydrop::app
