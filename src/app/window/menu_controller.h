// What the menu shows and does beside the settings themselves: presets, words for the command line, and what
// it remembers between flights. Main thread.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/settings/kept_file.h"
#include "app/settings/preset_store.h"
#include "app/settings/settings.h"
#include "skydrop/core/settings_table.h"
#include "skydrop/render/frame/view.h"
#include "skydrop/ui/menu.h"

namespace skydrop::app {

class MenuController {
 public:
  // `userFolder`: where presets and the menu's state are kept; nullopt: nowhere.
  explicit MenuController(std::optional<std::filesystem::path> userFolder);

  // What a frame of the menu shows; valid until the next call. `base`: what a run of this scene starts from.
  ui::MenuTools tools(const core::SettingsTable& base, const render::View& view,
                      std::span<const double> frameMs);

  // Does what was asked for with a preset. Throws core::RangeError and core::DataError, and has changed
  // nothing.
  struct Served {
    std::vector<std::string> changedPaths;
    std::string notice;
  };
  Served serve(const ui::PresetRequest& request, const core::SettingsTable& table,
               ui::ConfigurationMenu& menu);

  // What the menu remembers, "menu.json" in the player's folder (kept_file.h). What is wrong with the file
  // comes back as a line; the menu is there as at first. Saving writes what changed and throws
  // core::DataError.
  std::optional<std::string> load(ui::ConfigurationMenu& menu);
  std::optional<std::string> save(const ui::ConfigurationMenu& menu);

 private:
  KeptFile file_;
  ui::MenuState saved_;  // as the file was read or written last
  Settings defaults_;
  core::SettingsTable defaultTable_{defaults_};
  std::optional<PresetStore> presetStore_;
  std::optional<std::vector<ui::PresetEntry>> presets_;  // as last read; nullopt: to be read
  const core::SettingsTable* bases_[2] = {};
  std::string pose_;
  std::vector<ui::GenusButton> genera_;
};

}  // namespace skydrop::app
