#include "skydrop/ui/split_labels.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "ui/text_plate.h"

namespace skydrop::ui {
namespace {

// In lines of text.
constexpr float kMargin = 0.5f, kGrip = 1.2f, kScaleWidth = 8;
constexpr ImU32 kGripColor = IM_COL32(245, 247, 250, 220), kGripEdge = IM_COL32(0, 0, 0, 200);

// As much of the text as there is room for.
std::string fitted(const Typeface& face, std::string text, float width) {
  if (plateWidth(face, text) <= width) return text;
  while (!text.empty() && plateWidth(face, text + "…") > width) {
    while (text.size() > 1 && (static_cast<unsigned char>(text.back()) & 0xc0) == 0x80) text.pop_back();
    text.pop_back();
  }
  return text.empty() ? text : text + "…";
}

void drawScale(ImDrawList& list, const Typeface& face, ImVec2 highRight,
               const std::vector<std::uint32_t>& colors) {
  const float width = kScaleWidth * face.pixels, height = std::floor(0.7f * face.pixels);
  const std::string low = "0", high = "1";
  const float left = highRight.x - width - plateWidth(face, high);
  const auto count = static_cast<float>(colors.size());
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const auto at = static_cast<float>(i);
    list.AddRectFilled({left + width * at / count, highRight.y},
                       {left + width * (at + 1) / count, highRight.y + height}, colors[i]);
  }
  list.AddRect({left, highRight.y}, {left + width, highRight.y + height}, kPlateText);
  const float text = highRight.y - std::floor(0.2f * face.pixels);
  drawPlate(list, face, {left - plateWidth(face, low), text}, low);
  drawPlate(list, face, {left + width, text}, high);
}

// A strip over the divider, as high as the window: it takes the mouse there and nowhere else.
std::optional<double> drag(const Interface& context, double divider) {
  const float width = std::floor(kGrip * context.text().pixels),
              x = static_cast<float>(divider) * static_cast<float>(context.width());
  ImGui::SetNextWindowPos({std::floor(x - width / 2), 0});
  ImGui::SetNextWindowSize({width, static_cast<float>(context.height())});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground |
                                      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing |
                                      ImGuiWindowFlags_NoBringToFrontOnFocus;
  std::optional<double> dragged;
  if (ImGui::Begin("##split divider", nullptr, kFlags)) {
    ImGui::InvisibleButton("grip", ImGui::GetContentRegionAvail());
    if (ImGui::IsItemActive() && ImGui::GetIO().MouseDelta.x != 0)
      dragged = std::clamp(static_cast<double>(ImGui::GetIO().MousePos.x) / context.width(), 0.0, 1.0);
  }
  ImGui::End();
  ImGui::PopStyleVar(2);
  return dragged;
}

void drawGrip(ImDrawList& list, const Interface& context, float x) {
  const float radius = std::floor(0.45f * context.text().pixels),
              y = std::floor(static_cast<float>(context.height()) / 2);
  list.AddCircleFilled({x, y}, radius, kGripColor, 24);
  list.AddCircle({x, y}, radius, kGripEdge, 24);
}

}  // namespace

std::optional<double> drawSplitLabels(const Interface& context, const SplitLabels& labels) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const Typeface& face = context.text();
  const auto width = static_cast<float>(context.width()), height = static_cast<float>(context.height());
  const float margin = std::floor(kMargin * face.pixels),
              divider = static_cast<float>(labels.divider) * width;
  const auto plate = [&](float x, float y, const std::string& text) {
    if (!text.empty()) drawPlate(list, face, {std::floor(x), std::floor(y)}, text);
  };
  const std::string left = fitted(face, labels.left, divider - 2 * margin),
                    right = fitted(face, labels.right, width - divider - 2 * margin),
                    note = fitted(face, labels.note, width - 2 * margin);
  plate(margin, margin, left);
  plate(width - margin - plateWidth(face, right), margin, right);
  const float low = height - margin - 1.4f * face.pixels;
  plate((width - plateWidth(face, note)) / 2, low, note);
  if (!labels.scale.empty() && width - divider > (kScaleWidth + 3) * face.pixels)
    drawScale(list, face, {width - margin, margin + 1.8f * face.pixels}, labels.scale);
  drawGrip(list, context, divider);
  return drag(context, labels.divider);
}

}  // namespace skydrop::ui
