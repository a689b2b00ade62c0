// A field's label and its editor in one line, as the tools beside the game show theirs: the value is set at
// once.
#pragma once

#include <optional>
#include <string>

#include "skydrop/core/settings_table.h"
#include "ui/menu_item.h"
#include "ui/row_editor.h"

namespace skydrop::ui {

struct ToolRow {
  bool changed = false;
  bool held = false;                   // the mouse holds its slider: more may follow
  std::optional<std::string> refusal;  // why a typed value was not set
};

// Where the editor lies is added to `places` by the field's path.
ToolRow drawToolRow(RowEditor& rows, const core::Field& field, float labelWidth, ItemPlaces& places);

}  // namespace skydrop::ui
