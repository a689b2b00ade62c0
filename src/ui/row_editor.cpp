#include "ui/row_editor.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>

#include "ui/field_label.h"
#include "ui/key_press.h"
#include "ui/menu_item.h"

namespace skydrop::ui {
namespace {

using core::Field;
using core::FieldKind;

constexpr double kWidestSlider = 1e9;  // a slider over more than that cannot be aimed
constexpr int kFramesToFocus = 5;      // a field that did not get the keyboard by then never will
constexpr float kStillClick = 0.3f;    // lines of text: a press that moved less is a click

bool drawChoice(const Field& field, double& value) {
  const auto index = static_cast<std::size_t>(std::clamp(value, field.min, field.max));
  bool edited = false;
  if (ImGui::BeginCombo("##value", field.names[index].c_str())) {
    for (std::size_t i = 0; i < field.names.size(); ++i) {
      if (ImGui::Selectable(field.names[i].c_str(), i == index)) {
        value = static_cast<double>(i);
        edited = true;
      }
    }
    ImGui::EndCombo();
  }
  return edited;
}

// A slider that stops at powers of two; a typed value between them is shown as it is.
bool drawPowersOfTwo(const Field& field, double& value) {
  auto exponent = static_cast<int>(std::lround(std::log2(value)));
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  const bool edited = ImGui::SliderInt(
      "##value", &exponent, static_cast<int>(std::ceil(std::log2(field.sliderMin))),
      static_cast<int>(std::floor(std::log2(field.sliderMax))), (text + (" " + unitText(field))).c_str(),
      ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput);
  if (edited) value = std::exp2(exponent);
  return edited;
}

bool drawNumber(const Field& field, double& value) {
  if (field.powersOfTwo && field.sliderMin > 0) return drawPowersOfTwo(field, value);
  ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput;
  if (field.logarithmic && field.sliderMin > 0) flags |= ImGuiSliderFlags_Logarithmic;
  const std::string format = sliderFormat(field);
  if (field.kind == FieldKind::number) {
    return ImGui::SliderScalar("##value", ImGuiDataType_Double, &value, &field.sliderMin, &field.sliderMax,
                               format.c_str(), flags);
  }
  auto number = static_cast<std::int64_t>(value);
  const auto low = static_cast<std::int64_t>(field.sliderMin),
             high = static_cast<std::int64_t>(field.sliderMax);
  const bool edited =
      ImGui::SliderScalar("##value", ImGuiDataType_S64, &number, &low, &high, format.c_str(), flags);
  if (edited) value = static_cast<double>(number);
  return edited;
}

// Tab goes to the next row instead of into the text.
int dropTabs(ImGuiInputTextCallbackData* data) { return data->EventChar == '\t' ? 1 : 0; }

}  // namespace

bool RowEditor::isTyped(const Field& field) {
  return field.kind == FieldKind::number || field.kind == FieldKind::integer;
}

void RowEditor::type(const Field& field) {
  pending_.erase(field.path);
  Typing& typing = typing_.emplace(Typing{});
  typing.path = field.path;
  typing.first = core::fieldText(field);
  typing.framesToFocus = kFramesToFocus;
  typing.first.copy(typing.text, sizeof typing.text - 1);
}

RowOutcome RowEditor::draw(const Field& field, ScreenRect& place) {
  if (typing_ && typing_->path == field.path) return drawTyping(field, place);
  if (isTyped(field)) return drawSlider(field, place);
  RowOutcome outcome;
  double value = field.get();
  bool edited = false;
  if (field.kind == FieldKind::flag) {
    bool on = value != 0;
    edited = ImGui::Checkbox("##value", &on);
    place = lastItemRect();
    value = on ? 1 : 0;
  } else {
    ImGui::SetNextItemWidth(-1);
    edited = drawChoice(field, value);
    place = lastItemRect();
  }
  if (edited) outcome.value = value;
  return outcome;
}

RowOutcome RowEditor::drawTyping(const Field& field, ScreenRect& place) {
  RowOutcome outcome;
  const std::string unit = unitText(field);
  const float unitWidth =
      unit.empty() ? 0 : ImGui::CalcTextSize(unit.c_str()).x + ImGui::GetStyle().ItemSpacing.x;
  ImGui::SetNextItemWidth(-std::max(unitWidth, 1.0f));
  if (typing_->framesToFocus > 0) ImGui::SetKeyboardFocusHere();
  constexpr ImGuiInputTextFlags kFlags = ImGuiInputTextFlags_AutoSelectAll |
                                         ImGuiInputTextFlags_AllowTabInput |
                                         ImGuiInputTextFlags_CallbackCharFilter;
  ImGui::InputText("##typed", typing_->text, sizeof typing_->text, kFlags, dropTabs);
  place = lastItemRect();
  const bool active = ImGui::IsItemActive();
  const bool tab = active && isPressed(MenuKey::tab);
  const bool left = ImGui::IsItemDeactivated();
  if (!unit.empty()) {
    ImGui::SameLine();
    ImGui::TextDisabled("%s", unit.c_str());
  }
  if (active) typing_->framesToFocus = 0;
  if (tab || left) {
    if (typing_->text != typing_->first) outcome.typed = typing_->text;
    if (tab) outcome.nextRow = isShiftHeld() ? -1 : 1;
    typing_.reset();
  } else if (!active && --typing_->framesToFocus <= 0) {
    typing_.reset();
  }
  return outcome;
}

RowOutcome RowEditor::drawSlider(const Field& field, ScreenRect& place) {
  RowOutcome outcome;
  if (field.sliderMax - field.sliderMin > kWidestSlider) {
    const std::string unit = unitText(field);
    if (ImGui::Button((core::fieldText(field) + (unit.empty() ? "" : " " + unit) + "##value").c_str(),
                      {-1, 0})) {
      outcome.wantsToType = true;
    }
    place = lastItemRect();
    return outcome;
  }
  ImGui::SetNextItemWidth(-1);
  const double before = field.get();
  const auto waiting = pending_.find(field.path);
  double value = waiting == pending_.end() ? before : waiting->second.value;
  const bool edited = drawNumber(field, value);
  place = lastItemRect();
  if (ImGui::IsItemHovered()) {
    const bool twice = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    if (twice && press_ && press_->path == field.path) outcome.before = press_->before;
    if (twice || ImGui::IsMouseClicked(ImGuiMouseButton_Right) ||
        (ImGui::IsMouseClicked(ImGuiMouseButton_Left) && isControlHeld())) {
      outcome.wantsToType = true;
      return outcome;
    }
  }
  if (ImGui::IsItemActivated()) press_ = Press{field.path, before};
  if (core::isWhileHeld(field.takesEffect)) {
    outcome.held = ImGui::IsItemActive();
    if (edited) outcome.value = value;
    return outcome;
  }
  if (edited) pending_.insert_or_assign(field.path, Pending{value, std::nullopt});
  const auto mine = pending_.find(field.path);
  if (mine == pending_.end() || ImGui::IsItemActive()) return outcome;
  // What is slow waits for the release; after a click also until no second one can follow.
  const float still = kStillClick * ImGui::GetFontSize();
  const bool clicked = ImGui::GetIO().MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] < still * still;
  if (!mine->second.releasedAt) mine->second.releasedAt = ImGui::GetTime();
  if (!clicked || ImGui::GetTime() - *mine->second.releasedAt > kDoubleClickSeconds) {
    outcome.value = mine->second.value;
    pending_.erase(mine);
  }
  return outcome;
}

}  // namespace skydrop::ui
