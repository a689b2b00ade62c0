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

// What its present value comes to, or why it does nothing now; empty where nothing has to be said.
std::string noteText(const core::Field& field);

// What it does, its note, its other names, the slider's range and that of typing, its default, how a change
// takes effect, and its path for --set.
std::string tooltipText(const core::Field& field);

// The same without the note: it does not change while a row is edited, so a search may look into it.
std::string searchText(const core::Field& field);

}  // namespace skydrop::ui
