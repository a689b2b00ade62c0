// A JSON file of settings: {"schema": 1, "settings": {"aircraft": {"mass": 900}}}. The player's settings,
// presets and qualities all have this form, with other members beside `settings` where a kind of file needs
// them. Any thread.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

namespace skydrop::core {

inline constexpr int kSettingsSchema = 1;

// The whole object; `settings` is in it and an object, the schema is ours. At most 1 MiB. Throws DataError
// that names the file, the place and the reason; what the settings say is judged by applyJson().
nlohmann::json readSettingsFile(const std::filesystem::path& file);

// Writes `members` with the schema, so that not even a loss of power loses the file, and makes the folder. Throws
// DataError.
void writeSettingsFile(const std::filesystem::path& file, const nlohmann::json& members);

}  // namespace skydrop::core
