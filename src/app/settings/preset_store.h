// The player's presets: named sets of settings, one JSON file each (core/settings_file.h) in a folder of
// their own. A preset holds whole groups of settings: of these the values that differ from their defaults;
// loading it sets every other value of the groups to its default, and nothing outside them. So a preset means
// the same in every scene, and one of a single section can be laid over any flight. Main thread.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/settings/settings.h"
#include "skydrop/core/settings_table.h"
#include "skydrop/ui/menu.h"

namespace skydrop::app {

// Why `name` cannot name a preset; empty when it can: 1 to 64 letters, digits, spaces and "-_.()" of ASCII,
// that begin and end with neither a space nor a dot. So it is a file's name everywhere, and never a path.
std::string presetNameRefusal(std::string_view name);

// The values that a preset's file sets, for a table of app::Settings. Throws core::DataError.
std::vector<ui::SettingValue> readPreset(const std::filesystem::path& file);

class PresetStore {
 public:
  // `folder`: the presets' own ("~/.config/skydrop/presets"); need not exist.
  explicit PresetStore(std::filesystem::path folder) : folder_(std::move(folder)) {}

  // By name; the broken ones too, with what is wrong with them. Reads the folder.
  std::vector<ui::PresetEntry> list() const;

  // `groups`: of the table ("aircraft", "render.sun"); empty: every group but those that belong to the player
  // and not to the game (what is heard, how it is looked at), and the scene's effects. Replaces a preset of
  // the same name; one that cannot be read is kept aside, and its new name comes back. Throws
  // core::RangeError (name, group) and core::DataError (file).
  std::optional<std::filesystem::path> save(const std::string& name, const core::SettingsTable& table,
                                            const std::vector<std::string>& groups) const;

  // Throws core::RangeError (name) and core::DataError.
  std::vector<ui::SettingValue> load(const std::string& name) const;
  void remove(const std::string& name) const;

  // The file of a preset. Throws core::RangeError.
  std::filesystem::path file(const std::string& name) const;

 private:
  std::filesystem::path folder_;
};

// Where presets are kept in a player's folder.
std::filesystem::path presetFolder(const std::filesystem::path& userFolder);

// --preset NAME|FILE|-, as PATH=VALUE for each value: a word with a slash or that ends in .json is a file,
// "-" is standard input, any other a name on the shelf. Throws core::UsageError (name) and core::DataError.
std::vector<std::string> presetOfCommandLine(const std::string& word, const std::filesystem::path& folder);

}  // namespace skydrop::app
