#include "skydrop/ui/noise_tool_view.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "ui/menu_item.h"
#include "ui/row_editor.h"
#include "ui/texture_id.h"
#include "ui/tool_row.h"

namespace skydrop::ui {
namespace {

constexpr float kPanelLines = 27, kLabelLines = 9, kHistogramLines = 4;
constexpr ImU32 kSky = IM_COL32(92, 142, 196, 255), kGround = IM_COL32(20, 24, 30, 255);

}  // namespace

struct NoiseToolView::Parts {
  RowEditor rows;
  ItemPlaces places;
  char file[512] = "noise.dds";

  void row(const core::Field& field, float labelWidth, NoiseToolResult& result);
  void panel(const NoiseToolContent& content, float line, NoiseToolResult& result);
};

NoiseToolView::NoiseToolView() : parts_(std::make_unique<Parts>()) {}
NoiseToolView::~NoiseToolView() = default;

void NoiseToolView::Parts::row(const core::Field& field, float labelWidth, NoiseToolResult& result) {
  ToolRow drawn = drawToolRow(rows, field, labelWidth, places);
  result.changed = result.changed || drawn.changed;
  result.held = result.held || drawn.held;
  if (drawn.refusal) result.refusal = std::move(drawn.refusal);
}

void NoiseToolView::Parts::panel(const NoiseToolContent& content, float line, NoiseToolResult& result) {
  for (const NoiseToolContent::Section& section : content.sections) {
    ImGui::TextDisabled("%s", std::string(section.title).c_str());
    for (const std::string_view path : section.rows) row(content.table.at(path), kLabelLines * line, result);
    ImGui::Spacing();
  }
  ImGui::TextDisabled("Histogram");
  if (content.histogram.size() > 1) {
    // Clear sky would dwarf the rest.
    const auto counted = content.histogram.subspan(1);
    const float most = *std::max_element(counted.begin(), counted.end());
    ImGui::PlotHistogram("##histogram", content.histogram.data(), static_cast<int>(content.histogram.size()),
                         0, nullptr, 0, most, {ImGui::GetContentRegionAvail().x, kHistogramLines * line});
  }
  ImGui::TextUnformatted(content.status.data(), content.status.data() + content.status.size());
  ImGui::ProgressBar(static_cast<float>(content.progress.value_or(1)), {-1, 0.4f * line}, "");
  ImGui::Spacing();
  ImGui::TextDisabled("File");
  ImGui::SetNextItemWidth(-1);
  ImGui::InputText("##file", file, sizeof file);
  places["file"] = lastItemRect();
  if (placedButton("Save as DDS", "Save as DDS", places, content.canSave)) result.save = file;
  ImGui::SameLine();
  if (placedButton("Open", "Open", places)) result.open = file;
  if (content.canUseInSky && placedButton("Use in the sky", "Use in the sky", places)) result.useInSky = true;
  textInPlace(content.message, 2, TextRole::note);
}

NoiseToolResult NoiseToolView::draw(const Interface& context, const NoiseToolContent& content) {
  NoiseToolResult result;
  parts_->places.clear();
  const float line = context.text().pixels;
  const auto width = static_cast<float>(context.width()), height = static_cast<float>(context.height());
  const float panelWidth = std::floor(std::min(kPanelLines * line, 0.6f * width));
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize({panelWidth, height});
  constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoDecoration & ~ImGuiWindowFlags_NoScrollbar;
  if (ImGui::Begin("Make some noise", nullptr,
                   kFixed | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings))
    parts_->panel(content, line, result);
  ImGui::End();

  // The pictures share what is left, as squares.
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.AddRectFilled({0, 0}, {width, height}, kGround);
  const auto count = static_cast<float>(std::max<std::size_t>(content.pictures.size(), 1));
  const float room = width - panelWidth, margin = line / 2;
  const bool sideBySide = room >= height;
  const float side =
      std::floor(sideBySide ? std::min(height - 2 * margin, room / count - (1 + 1 / count) * margin)
                            : std::min(room - 2 * margin, height / count - (1 + 1 / count) * margin));
  float left = panelWidth + margin, top = margin;
  for (const ToolPicture& picture : content.pictures) {
    const ImVec2 from{std::floor(left), std::floor(top)}, to{std::floor(left + side), std::floor(top + side)};
    if (picture.overSky) list.AddRectFilled(from, to, kSky);
    const float end = picture.tiled ? 2.0f : 1.0f;
    if (picture.texture != 0 && side > 0) {
      list.AddImage(textureId(picture.texture), from, to, {0, picture.upsideDown ? end : 0},
                    {end, picture.upsideDown ? 0 : end});
    }
    (sideBySide ? left : top) += side + margin;
  }
  return result;
}

std::optional<ScreenRect> NoiseToolView::placeOf(std::string_view name) const {
  const auto found = parts_->places.find(name);
  if (found == parts_->places.end()) return std::nullopt;
  return found->second;
}

}  // namespace skydrop::ui
