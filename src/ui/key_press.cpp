#include "ui/key_press.h"

#include <imgui.h>

namespace skydrop::ui {
namespace {

#if IMGUI_VERSION_NUM >= 18900

bool pressed(ImGuiKey key, bool repeat) { return ImGui::IsKeyPressed(key, repeat); }
bool findPressed() { return ImGui::IsKeyPressed(ImGuiKey_F, false); }
constexpr ImGuiKey kKeypadEnter = ImGuiKey_KeypadEnter;

#else

bool pressed(ImGuiKey key, bool repeat) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), repeat); }
// Before 1.89 few letters have names; all keys are in an array under the window's own codes.
bool findPressed() { return ImGui::IsKeyPressed('F', false); }
constexpr ImGuiKey kKeypadEnter = ImGuiKey_KeyPadEnter;

#endif

}  // namespace

bool isPressed(MenuKey key) {
  switch (key) {
    case MenuKey::up:
      return pressed(ImGuiKey_UpArrow, true);
    case MenuKey::down:
      return pressed(ImGuiKey_DownArrow, true);
    case MenuKey::enter:
      return pressed(ImGuiKey_Enter, false);
    case MenuKey::keypadEnter:
      return pressed(kKeypadEnter, false);
    case MenuKey::tab:
      return pressed(ImGuiKey_Tab, true);
    case MenuKey::escape:
      return pressed(ImGuiKey_Escape, false);
    case MenuKey::find:
      return findPressed();
    case MenuKey::undo:
      return pressed(ImGuiKey_Z, true);
    case MenuKey::redo:
      return pressed(ImGuiKey_Y, true);
  }
  return false;
}

bool isControlHeld() { return ImGui::GetIO().KeyCtrl; }
bool isShiftHeld() { return ImGui::GetIO().KeyShift; }

}  // namespace skydrop::ui
