// The player's own settings: what was changed in the menu, kept between flights.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "app/bindings.h"
#include "skydrop/core/settings_table.h"

namespace skydrop::app {

// The player's file in their folder.
std::filesystem::path userSettingsFile(const std::filesystem::path& folder);

// $XDG_CONFIG_HOME/skydrop, or ~/.config/skydrop; empty where neither variable is set.
std::filesystem::path defaultUserFolder();

// Runs `load` if the file exists. If it throws core::DataError the file is broken, which in the player's
// folder is no failure: it is renamed to NAME.bad and the line to say so comes back.
std::optional<std::string> loadOrSetAside(const std::filesystem::path& file,
                                          const std::function<void()>& load);

// What differs from `base`, as nested JSON: what is worth keeping.
nlohmann::json changedJson(const core::SettingsTable& table, const core::SettingsTable& base);

// Applies settings.json of the folder, if there is one: settings, and the bindings that it changes. A broken
// file is the one exception of the failure policy: it is renamed to settings.json.bad, nothing of it is
// applied, and the line to say so comes back.
std::optional<std::string> loadUserSettings(const core::SettingsTable& table, Bindings& bindings,
                                            const std::filesystem::path& folder);

// Applies the file as it stands now: after it was edited while flying. All or nothing: throws
// core::DataError.
void readUserSettings(const core::SettingsTable& table, Bindings& bindings,
                      const std::filesystem::path& folder);

// Writes what differs, or nothing where nothing does and there is no file: from `base` (the values before the
// player's file and the menu came in) and from the default bindings. Makes the folder. Throws
// core::DataError.
void saveUserSettings(const core::SettingsTable& table, const core::SettingsTable& base,
                      const Bindings& bindings, const std::filesystem::path& folder);

}  // namespace skydrop::app
