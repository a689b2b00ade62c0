#include "ui/menu_item.h"

#include <imgui.h>

#include <algorithm>

namespace skydrop::ui {
namespace {

constexpr float kTooltipWidth = 24;  // lines of text
const ImVec4 kRefusalColor{1, 0.45f, 0.35f, 1};

// The longest of the text without a part in its middle that fits. UTF-8 letters stay whole.
template <class Fits>
std::string withoutMiddle(std::string_view text, Fits fits) {
  const auto isInsideLetter = [&](std::size_t at) {
    return at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80;
  };
  const auto keeping = [&](std::size_t kept) {
    if (kept >= text.size()) return std::string(text);
    std::size_t head = kept / 2, tail = text.size() - (kept - kept / 2);
    while (isInsideLetter(head)) --head;
    while (isInsideLetter(tail)) ++tail;
    return std::string(text.substr(0, head)) + "\u2026" + std::string(text.substr(tail));
  };
  if (fits(keeping(text.size()))) return std::string(text);
  std::size_t most = 0, tooMany = text.size();
  while (tooMany - most > 1) {
    const std::size_t middle = most + (tooMany - most) / 2;
    (fits(keeping(middle)) ? most : tooMany) = middle;
  }
  return keeping(most);
}

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

// The next column, flush right.
void rightCell(const std::string& text) {
  ImGui::TableNextColumn();
  const float gap = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(gap, 0.0f));
  ImGui::TextUnformatted(text.c_str());
}

std::string fittingText(std::string text, float width) {
  if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
  while (!text.empty() && ImGui::CalcTextSize((text + "\u2026").c_str()).x > width) text.pop_back();
  return text + "\u2026";
}

void textInPlace(std::string_view text, int lines, TextRole role) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const float height = static_cast<float>(lines) * ImGui::GetTextLineHeight();
  ImGui::Dummy({width, height});
  if (text.empty()) return;
  tooltip(text);
  const std::string shown = withoutMiddle(text, [&](const std::string& candidate) {
    return ImGui::CalcTextSize(candidate.c_str(), nullptr, false, width).y < height + 1;
  });
  const ImVec4 color =
      role == TextRole::refusal ? kRefusalColor : ImGui::GetStyleColorVec4(ImGuiCol_CheckMark);
  ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), ImGui::GetFontSize(), at, ImGui::GetColorU32(color),
                                      shown.c_str(), nullptr, width);
}

}  // namespace skydrop::ui
