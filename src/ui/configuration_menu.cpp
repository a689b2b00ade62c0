#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "skydrop/ui/menu.h"
#include "ui/field_label.h"
#include "ui/statistics_view.h"

namespace skydrop::ui {
namespace {

using core::Field;
using core::FieldKind;
using core::TakesEffect;

// Sizes in lines of text. The menu leaves the score above and the instruments below free.
constexpr float kWidth = 30, kTop = 2.8f, kMargin = 0.5f, kBottomOfHeight = 0.2f, kAboveBottom = 1.2f;
constexpr float kMinHeight = 8;
constexpr double kWidestSlider = 1e9;  // a slider over more than that cannot be aimed

ScreenRect lastItemRect() {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  return {low.x, low.y, high.x, high.y};
}

void tooltip(const std::string& text, float line) {
  if (!ImGui::IsItemHovered()) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(24 * line);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

bool belongsTo(const Field& field, const std::string& group) {
  return field.group == group || (!group.empty() && field.group.starts_with(group + "."));
}

}  // namespace

void ConfigurationMenu::commit(const Field& field, double value, MenuResult& result) {
  if (field.kind != FieldKind::number) value = std::round(value);
  value = std::clamp(value, field.min, field.max);
  if (!std::isfinite(value) || value == field.get()) return;
  core::setField(field, value);
  if (std::ranges::find(result.changedPaths, field.path) == result.changedPaths.end()) {
    result.changedPaths.push_back(field.path);
  }
}

// Draws the widget of a value and changes it; true while the user does.
bool ConfigurationMenu::editValue(const Field& field, double& value) {
  switch (field.kind) {
    case FieldKind::flag: {
      bool on = value != 0;
      const bool edited = ImGui::Checkbox("##value", &on);
      value = on ? 1 : 0;
      return edited;
    }
    case FieldKind::choice: {
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
    case FieldKind::number:
    case FieldKind::integer:
      break;
  }
  const bool sliding = field.max - field.min <= kWidestSlider;
  ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp;
  if (field.logarithmic && field.min > 0) flags |= ImGuiSliderFlags_Logarithmic;
  const std::string format = sliderFormat(field);
  if (field.kind == FieldKind::integer) {
    const auto whole = [](double v) { return static_cast<std::int64_t>(std::clamp(v, -9e18, 9e18)); };
    std::int64_t number = whole(value);
    const std::int64_t low = whole(field.min), high = whole(field.max);
    const bool edited = sliding ? ImGui::SliderScalar("##value", ImGuiDataType_S64, &number, &low, &high,
                                                      format.c_str(), flags)
                                : ImGui::InputScalar("##value", ImGuiDataType_S64, &number);
    if (edited) value = static_cast<double>(number);
    return edited;
  }
  return sliding ? ImGui::SliderScalar("##value", ImGuiDataType_Double, &value, &field.min, &field.max,
                                       format.c_str(), flags)
                 : ImGui::InputDouble("##value", &value, 0, 0, format.c_str());
}

void ConfigurationMenu::drawRow(const Field& field, MenuResult& result) {
  const float line = ImGui::GetFontSize();
  ImGui::PushID(field.path.c_str());
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(humanName(field.name).c_str());
  tooltip(tooltipText(field), line);

  ImGui::TableNextColumn();
  ImGui::SetNextItemWidth(-1);
  const bool held = pending_ && pending_->path == field.path;
  double value = held ? pending_->value : field.get();
  const bool edited = editValue(field, value);
  MenuRowPlace place{lastItemRect(), std::nullopt};
  const bool number = field.kind == FieldKind::number || field.kind == FieldKind::integer;
  if (!number || field.takesEffect == TakesEffect::live) {
    if (edited) commit(field, value, result);
  } else {
    if (edited) pending_ = PendingEdit{field.path, value};
    if (ImGui::IsItemDeactivatedAfterEdit()) {
      commit(field, value, result);
      pending_.reset();
    } else if (held && !ImGui::IsItemActive()) {
      pending_.reset();
    }
  }
  if (!ImGui::IsItemActive()) tooltip(tooltipText(field), line);

  ImGui::TableNextColumn();
  if (!field.isDefault()) {
    if (ImGui::Button("Reset")) commit(field, field.defaultValue, result);
    place.reset = lastItemRect();
  }
  ImGui::PopID();
  places_.insert_or_assign(field.path, place);
}

MenuResult ConfigurationMenu::draw(const Interface& context, const MenuContent& content) {
  MenuResult result;
  places_.clear();
  const float line = context.text().pixels;
  const auto windowWidth = static_cast<float>(context.width()),
             windowHeight = static_cast<float>(context.height());
  // A new window size places the menu anew, so that it is never left outside.
  const bool moved = placedWidth_ != context.width() || placedHeight_ != context.height();
  placedWidth_ = context.width();
  placedHeight_ = context.height();
  const ImGuiCond when = moved ? ImGuiCond_Always : ImGuiCond_Once;
  ImGui::SetNextWindowPos({kMargin * line, kTop * line}, when);
  const float height = windowHeight * (1 - kBottomOfHeight) - (kTop + kAboveBottom) * line;
  ImGui::SetNextWindowSize(
      {std::min(kWidth * line, windowWidth - 2 * kMargin * line), std::max(height, kMinHeight * line)}, when);

  bool open = true;
  if (ImGui::Begin("Configuration", &open, ImGuiWindowFlags_NoCollapse)) {
    const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    place_ = {low.x, low.y, low.x + size.x, low.y + size.y};
    titleHeight_ = ImGui::GetFrameHeight();
    if (!content.error.empty()) {
      ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(1, 0.45f, 0.35f, 1));
      ImGui::PushTextWrapPos(0);
      ImGui::TextUnformatted(content.error.data(), content.error.data() + content.error.size());
      ImGui::PopTextWrapPos();
      ImGui::PopStyleColor();
    }
    const bool resetAll = ImGui::Button("Reset all");
    resetAllPlace_ = lastItemRect();
    tooltip("Sets every row of this menu to its default.", line);
    for (const MenuSection& section : content.sections) {
      if (resetAll) {
        for (const Field& field : content.table.fields()) {
          if (belongsTo(field, section.group)) commit(field, field.defaultValue, result);
        }
      }
      ImGui::SetNextItemOpen(section.open, ImGuiCond_Once);
      if (!ImGui::CollapsingHeader((section.title + "###section " + section.group).c_str())) continue;
      const std::string id = "fields " + section.group;
      if (!ImGui::BeginTable(id.c_str(), 3, ImGuiTableFlags_SizingStretchProp)) continue;
      ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch, 0.42f);
      ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch, 0.58f);
      ImGui::TableSetupColumn("reset", ImGuiTableColumnFlags_WidthFixed,
                              ImGui::CalcTextSize("Reset").x + line);
      std::string group = section.group;
      for (const Field& field : content.table.fields()) {
        if (!belongsTo(field, section.group)) continue;
        if (field.group != group) {
          group = field.group;
          ImGui::TableNextRow();
          ImGui::TableNextColumn();
          ImGui::TextDisabled(
              "%s", humanName(group.substr(section.group.empty() ? 0 : section.group.size() + 1)).c_str());
        }
        drawRow(field, result);
      }
      ImGui::EndTable();
    }
    if (content.statistics && ImGui::CollapsingHeader("What accuracy costs"))
      drawStatistics(*content.statistics);
  }
  ImGui::End();
  result.closed = !open;
  return result;
}

ScreenRect ConfigurationMenu::crossPlace() const {
  return {place_.right - titleHeight_, place_.top, place_.right, place_.top + titleHeight_};
}

}  // namespace skydrop::ui
