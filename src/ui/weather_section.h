// What the section of the weather has above its rows: a picture of each genus of clouds to click.
#pragma once

#include <span>
#include <vector>

#include "skydrop/core/settings_table.h"
#include "skydrop/ui/menu.h"
#include "ui/menu_item.h"

namespace skydrop::ui {

// Returns the values to set for what was clicked in this frame; empty: nothing. Places: "genus NAME".
std::vector<SettingValue> drawGenusButtons(const core::SettingsTable& table,
                                           std::span<const GenusButton> genera, ItemPlaces& places);

}  // namespace skydrop::ui
