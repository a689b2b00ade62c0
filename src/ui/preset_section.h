// The section of the menu that saves, loads and deletes presets.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "skydrop/ui/menu.h"
#include "ui/menu_item.h"

namespace skydrop::ui {

class PresetSection {
 public:
  // What the user asked for in this frame.
  std::optional<PresetRequest> draw(std::span<const PresetEntry> presets,
                                    std::span<const MenuSection> sections, ItemPlaces& places);

 private:
  char name_[65] = {};
  std::string group_;         // that is saved; empty: all
  std::string confirmation_;  // the preset whose deletion waits to be confirmed
};

}  // namespace skydrop::ui
