// How the menu writes a field: pure text, no Dear ImGui.
#pragma once

#include <string>
#include <string_view>

#include "skydrop/core/settings_table.h"

namespace skydrop::ui {

// "rollFactor" -> "Roll factor"
std::string humanName(std::string_view name);

// "m/s²"; empty for a pure number, a flag or a choice.
std::string unitText(const core::Field& field);

// A typed value without spaces around it and without its unit, in either spelling.
std::string_view withoutUnit(const core::Field& field, std::string_view text);

// printf format of the field's slider: digits and unit, a per cent sign doubled.
std::string sliderFormat(const core::Field& field);

// What it does, its range, its default, how a change takes effect, and its path for --set.
std::string tooltipText(const core::Field& field);

}  // namespace skydrop::ui
