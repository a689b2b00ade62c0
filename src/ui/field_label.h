// How the menu writes a field: pure text, no Dear ImGui.
#pragma once

#include <string>
#include <string_view>

#include "skydrop/core/settings_table.h"

namespace skydrop::ui {

// "rollFactor" -> "Roll factor"
std::string humanName(std::string_view name);

// printf format of the field's slider: digits and unit, a per cent sign doubled.
std::string sliderFormat(const core::Field& field);

// What it does, its range, its default, how a change takes effect, and its path for --set.
std::string tooltipText(const core::Field& field);

}  // namespace skydrop::ui
