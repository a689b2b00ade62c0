#include <imgui.h>

#include "skydrop/ui/menu.h"
#include "ui/key_press.h"

namespace skydrop::ui {
namespace {

struct Entry {
  const char* label;
  EscapeAction action;
};

constexpr Entry kEntries[] = {
    {"Resume", EscapeAction::resume},
    {"Help", EscapeAction::help},
    {"Laboratory", EscapeAction::laboratory},
    {"Quit", EscapeAction::quit}};
constexpr int kEntryCount = static_cast<int>(std::size(kEntries));
constexpr float kButtonWidth = 12;  // lines of text

}  // namespace

EscapeAction EscapeMenu::draw(const Interface& context) {
  EscapeAction action = EscapeAction::none;
  if (isPressed(MenuKey::down)) selected_ = (selected_ + 1) % kEntryCount;
  if (isPressed(MenuKey::up)) selected_ = (selected_ + kEntryCount - 1) % kEntryCount;
  if (isPressed(MenuKey::enter) || isPressed(MenuKey::keypadEnter)) action = kEntries[selected_].action;

  const ImVec2 middle(static_cast<float>(context.width()) / 2, static_cast<float>(context.height()) / 2);
  ImGui::SetNextWindowPos(middle, ImGuiCond_Always, {0.5f, 0.5f});
  constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                      ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize;
  places_.clear();
  ImGui::Begin("Skydrop", nullptr, kFlags);
  const ImVec2 mouse = ImGui::GetIO().MouseDelta;
  for (int i = 0; i < kEntryCount; ++i) {
    const bool chosen = i == selected_;
    if (chosen) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    if (ImGui::Button(kEntries[i].label, {kButtonWidth * context.text().pixels, 0}))
      action = kEntries[i].action;
    if (chosen) ImGui::PopStyleColor();
    // The mouse selects when it moves, so that a mouse at rest does not hold the keys back.
    if (ImGui::IsItemHovered() && (mouse.x != 0 || mouse.y != 0)) selected_ = i;
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    places_.push_back({low.x, low.y, high.x, high.y});
  }
  ImGui::End();
  return action;
}

}  // namespace skydrop::ui
