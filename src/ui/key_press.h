// Keys that the menus ask for, the same over the versions of Dear ImGui.
#pragma once

namespace skydrop::ui {

enum class MenuKey { up, down, enter, keypadEnter, tab, escape, find, undo, redo };

// Went down in this frame, or repeats while it is held (not enter and find).
bool isPressed(MenuKey key);
bool isControlHeld();
bool isShiftHeld();

}  // namespace skydrop::ui
