// The player's own settings: what was changed in the menu, kept between flights in settings.json of their
// folder, and edited there by hand.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "app/input/bindings.h"
#include "app/settings/kept_file.h"
#include "skydrop/core/settings_table.h"

namespace skydrop::app {

// The player's file in their folder.
std::filesystem::path userSettingsFile(const std::filesystem::path& folder);

// $XDG_CONFIG_HOME/skydrop, or ~/.config/skydrop; empty where neither variable is set.
std::filesystem::path defaultUserFolder();

// A value: what the file says, and what the menu chose since it was written. Main thread.
class UserSettings {
 public:
  UserSettings() = default;  // no folder: choices are held, nothing is read or written
  explicit UserSettings(const std::filesystem::path& folder) : file_(userSettingsFile(folder)) {}

  // Reads the file at the start; what is wrong with it comes back as one line. Broken as a whole it is set
  // aside (kept_file.h) and defaults are used; a value or key that does not fit is left out, and the rest
  // applies.
  std::optional<std::string> load();
  // The same after it was edited while flying, but what is broken as a whole is refused: throws
  // core::DataError, and the last state stays. What the menu chose and was not saved yet stays too.
  std::optional<std::string> reload();

  // The player's layer of the settings.
  void applyTo(const core::SettingsTable& table) const;
  const Bindings& bindings() const { return bindings_; }

  // What the menu chose: a value, or to follow the defaults again. It wins over the file when that is saved.
  void choose(const std::string& path, std::optional<double> value);

  // Writes what was chosen and which bindings changed into the file, and nothing else: `table` has the
  // values. Nothing is written where there is nothing new. The line to warn of comes back. Throws
  // core::DataError, and the choices wait for the next time.
  std::optional<std::string> save(const core::SettingsTable& table, const Bindings& bindings);

 private:
  std::optional<std::string> take();

  KeptFile file_;
  std::map<std::string, std::optional<double>> chosen_;
  Bindings bindings_;  // as in the file
};

// `into`, with every action that differs between `before` and `after` as it is in `after`.
Bindings mergedBindings(const Bindings& into, const Bindings& before, const Bindings& after);

}  // namespace skydrop::app
