#include "ui/menu_item.h"

#include <imgui.h>

namespace skydrop::ui {
namespace {

constexpr float kTooltipWidth = 24;  // lines of text
const ImVec4 kRefusalColor{1, 0.45f, 0.35f, 1};

}  // namespace

ScreenRect lastItemRect() {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  return {low.x, low.y, high.x, high.y};
}

void tooltip(std::string_view text) {
  if (text.empty()) return;
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(kTooltipWidth * ImGui::GetFontSize());
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

bool placedButton(const char* label, const std::string& name, ItemPlaces& places, bool enabled) {
  ImGui::BeginDisabled(!enabled);
  const bool pressed = ImGui::Button(label);
  ImGui::EndDisabled();
  places.insert_or_assign(name, lastItemRect());
  return pressed;
}

std::string fittingText(std::string text, float width) {
  if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
  while (!text.empty() && ImGui::CalcTextSize((text + "\u2026").c_str()).x > width) text.pop_back();
  return text + "\u2026";
}

void drawRefusal(std::string_view text) {
  if (text.empty()) return;
  ImGui::PushStyleColor(ImGuiCol_Text, kRefusalColor);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

}  // namespace skydrop::ui
