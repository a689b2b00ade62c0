#include "ui/tool_row.h"

#include <imgui.h>

#include "skydrop/core/error.h"
#include "ui/field_label.h"

namespace skydrop::ui {

ToolRow drawToolRow(RowEditor& rows, const core::Field& described, float labelWidth, ItemPlaces& places) {
  core::Field field = described;
  field.takesEffect = core::TakesEffect::live;  // a slider's every step is shown
  ToolRow result;
  ImGui::PushID(field.path.c_str());
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(humanName(field.name).c_str());
  tooltip(tooltipText(described));
  ImGui::SameLine(labelWidth);
  ScreenRect place;
  const RowOutcome outcome = rows.draw(field, place);
  places[field.path] = place;
  try {
    if (outcome.before) core::setField(field, *outcome.before);
    if (outcome.value) core::setField(field, *outcome.value);
    if (outcome.typed) core::setField(field, withoutUnit(field, *outcome.typed));
    result.changed = outcome.before || outcome.value || outcome.typed;
  } catch (const core::RangeError& refusal) {
    result.refusal = refusal.what();
  }
  result.held = outcome.held;
  if (outcome.wantsToType) rows.type(field);
  ImGui::PopID();
  return result;
}

}  // namespace skydrop::ui
