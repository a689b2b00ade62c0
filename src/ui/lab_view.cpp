#include "skydrop/ui/lab_view.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/field_label.h"
#include "ui/menu_item.h"
#include "ui/row_editor.h"
#include "ui/texture_id.h"
#include "ui/tool_row.h"

namespace skydrop::ui {
namespace {

constexpr float kListLines = 17, kKnobLines = 11.5f, kLabelLines = 9, kColumnLines = 22;
constexpr ImGuiWindowFlags kFixed = (ImGuiWindowFlags_NoDecoration & ~ImGuiWindowFlags_NoScrollbar) |
                                    ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;

// Where the picture and the knobs begin, pixels.
struct Split {
  float left, below;
};

Split splitOf(float width, float height, float line) {
  return {std::floor(std::min(kListLines * line, 0.4f * width)),
          std::floor(std::max(height - kKnobLines * line, 0.4f * height))};
}

}  // namespace

LabPictureSize labPictureSize(int width, int height, float linePixels) {
  const Split split = splitOf(static_cast<float>(width), static_cast<float>(height), linePixels);
  return {std::max(width - static_cast<int>(split.left), 1), std::max(static_cast<int>(split.below), 1)};
}

std::string knobFlags(const core::SettingsTable& table) {
  std::string flags;
  for (const core::Field& field : table.fields()) {
    if (!field.isDefault()) flags += " --set " + field.path + "=" + core::fieldText(field);
  }
  return flags;
}

struct LabView::Parts {
  RowEditor rows;
  ItemPlaces places;

  void list(const LabContent& content, LabResult& result);
  void row(const core::Field& field, float labelWidth, LabResult& result);
  void knobs(const LabContent& content, float line, LabResult& result);
  void picture(const LabContent& content, float line, LabResult& result);
};

LabView::LabView() : parts_(std::make_unique<Parts>()) {}
LabView::~LabView() = default;

void LabView::Parts::list(const LabContent& content, LabResult& result) {
  std::string_view chapter;
  for (std::size_t i = 0; i < content.entries.size(); ++i) {
    const LabEntry& entry = content.entries[i];
    if (entry.chapter != chapter) ImGui::TextDisabled("%s", humanName(entry.chapter).c_str());
    chapter = entry.chapter;
    if (ImGui::Selectable(std::string(entry.title).c_str(), i == content.chosen)) result.chosen = i;
    places[std::string(entry.name)] = lastItemRect();
  }
  ImGui::Separator();
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(content.text.data(), content.text.data() + content.text.size());
  ImGui::PopTextWrapPos();
}

void LabView::Parts::row(const core::Field& field, float labelWidth, LabResult& result) {
  ToolRow drawn = drawToolRow(rows, field, labelWidth, places);
  result.changed = result.changed || drawn.changed;
  result.held = result.held || drawn.held;
  if (drawn.refusal) result.refusal = std::move(drawn.refusal);
}

void LabView::Parts::knobs(const LabContent& content, float line, LabResult& result) {
  if (placedButton("Reset", "Reset", places)) result.reset = true;
  ImGui::SameLine();
  const std::string flags =
      "skydrop lab --page " + std::string(content.entries[content.chosen].name) + knobFlags(content.table);
  if (placedButton("Copy as --set", "Copy as --set", places)) ImGui::SetClipboardText(flags.c_str());
  tooltip(flags);
  ImGui::SameLine();
  if (placedButton("Measure cost and error", "Measure cost and error", places)) result.measure = true;
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(content.status.data(), content.status.data() + content.status.size());
  const auto columns =
      std::max(static_cast<int>(ImGui::GetContentRegionAvail().x / (kColumnLines * line)), 1);
  if (ImGui::BeginTable("knobs", columns)) {
    for (const core::Field& field : content.table.fields()) {
      ImGui::TableNextColumn();
      row(field, kLabelLines * line, result);
    }
    ImGui::EndTable();
  }
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(content.figures.data(), content.figures.data() + content.figures.size());
  ImGui::PopTextWrapPos();
}

void LabView::Parts::picture(const LabContent& content, float line, LabResult& result) {
  const ImVec2 size = ImGui::GetContentRegionAvail();
  const ImVec2 from = ImGui::GetCursorScreenPos(), to{from.x + size.x, from.y + size.y};
  if (size.x < 1 || size.y < 1) return;
  if (content.texture != 0)
    ImGui::GetWindowDrawList()->AddImage(textureId(content.texture), from, to, {0, 1}, {1, 0});
  ImGui::InvisibleButton("picture", size);
  places["picture"] = lastItemRect();
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemActive()) {
    result.turnedX = io.MouseDelta.x / line;
    result.turnedY = io.MouseDelta.y / line;
  }
  if (ImGui::IsItemHovered()) result.zoomed = io.MouseWheel;
}

LabResult LabView::draw(const Interface& context, const LabContent& content) {
  LabResult result;
  parts_->places.clear();
  const float line = context.text().pixels;
  const auto width = static_cast<float>(context.width()), height = static_cast<float>(context.height());
  const Split split = splitOf(width, height, line);
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize({split.left, height});
  if (ImGui::Begin("Laboratory", nullptr, kFixed)) parts_->list(content, result);
  ImGui::End();
  ImGui::SetNextWindowPos({split.left, split.below});
  ImGui::SetNextWindowSize({width - split.left, height - split.below});
  if (ImGui::Begin("Knobs", nullptr, kFixed)) parts_->knobs(content, line, result);
  ImGui::End();
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::SetNextWindowPos({split.left, 0});
  ImGui::SetNextWindowSize({width - split.left, split.below});
  constexpr ImGuiWindowFlags kStill = kFixed | ImGuiWindowFlags_NoScrollbar |
                                      ImGuiWindowFlags_NoScrollWithMouse |
                                      ImGuiWindowFlags_NoBringToFrontOnFocus;
  if (ImGui::Begin("Picture", nullptr, kStill)) parts_->picture(content, line, result);
  ImGui::End();
  ImGui::PopStyleVar();
  return result;
}

std::optional<ScreenRect> LabView::placeOf(std::string_view name) const {
  const auto found = parts_->places.find(name);
  if (found == parts_->places.end()) return std::nullopt;
  return found->second;
}

}  // namespace skydrop::ui
