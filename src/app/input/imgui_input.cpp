#include "app/input/imgui_input.h"

#include <imgui.h>

#include <cfloat>

#include "app/input/input_code.h"
#include "skydrop/ui/imgui_context.h"

namespace skydrop::app {
namespace {

using render::gl::WindowEvent;
using Kind = WindowEvent::Kind;

constexpr int kControlModifier = 0x0002;  // GLFW's
constexpr float kAnyTime = FLT_MAX;       // s
constexpr int kMouseButtons = 5;          // as many as Dear ImGui knows

#if IMGUI_VERSION_NUM >= 18900
constexpr ImGuiKey kImGuiKeypadEnter = ImGuiKey_KeypadEnter;
#else
constexpr ImGuiKey kImGuiKeypadEnter = ImGuiKey_KeyPadEnter;
#endif

struct KeyPair {
  int code;  // of a letter: the letter itself, wherever the layout has it
  ImGuiKey imgui;
};

// What Dear ImGui's widgets ask for.
constexpr KeyPair kKeys[] = {{key::kTab, ImGuiKey_Tab},
                             {key::kLeft, ImGuiKey_LeftArrow},
                             {key::kRight, ImGuiKey_RightArrow},
                             {key::kUp, ImGuiKey_UpArrow},
                             {key::kDown, ImGuiKey_DownArrow},
                             {key::kPageUp, ImGuiKey_PageUp},
                             {key::kPageDown, ImGuiKey_PageDown},
                             {key::kHome, ImGuiKey_Home},
                             {key::kEnd, ImGuiKey_End},
                             {key::kInsert, ImGuiKey_Insert},
                             {key::kDelete, ImGuiKey_Delete},
                             {key::kBackspace, ImGuiKey_Backspace},
                             {key::kSpace, ImGuiKey_Space},
                             {key::kEnter, ImGuiKey_Enter},
                             {key::kEscape, ImGuiKey_Escape},
                             {key::kKeypadEnter, kImGuiKeypadEnter},
                             {'A', ImGuiKey_A},
                             {'C', ImGuiKey_C},
#if IMGUI_VERSION_NUM >= 18900
                             {'F', ImGuiKey_F},
#endif
                             {'V', ImGuiKey_V},
                             {'X', ImGuiKey_X},
                             {'Y', ImGuiKey_Y},
                             {'Z', ImGuiKey_Z}};

bool isModifier(int code) { return code >= key::kLeftShift && code <= key::kRightSuper; }

#if IMGUI_VERSION_NUM >= 18900

void prepare(ImGuiIO& io) {
  io.ConfigInputTrickleEventQueue = false;  // EventFeed does that
}

void setKey(ImGuiIO& io, int code, bool pressed) {
  for (const KeyPair& pair : kKeys) {
    if (pair.code == code) io.AddKeyEvent(pair.imgui, pressed);
  }
}

void setModifiers(ImGuiIO& io, bool control, bool shift, bool alt, bool super) {
  io.AddKeyEvent(ImGuiMod_Ctrl, control);
  io.AddKeyEvent(ImGuiMod_Shift, shift);
  io.AddKeyEvent(ImGuiMod_Alt, alt);
  io.AddKeyEvent(ImGuiMod_Super, super);
}

void setMousePosition(ImGuiIO& io, float x, float y) { io.AddMousePosEvent(x, y); }
void setMouseButton(ImGuiIO& io, int button, bool pressed) { io.AddMouseButtonEvent(button, pressed); }
void addScroll(ImGuiIO& io, float x, float y) { io.AddMouseWheelEvent(x, y); }

#else

void prepare(ImGuiIO& io) {
  for (const KeyPair& pair : kKeys) io.KeyMap[pair.imgui] = pair.code;
}

void setKey(ImGuiIO& io, int code, bool pressed) {
  if (code >= 0 && code <= key::kLast) io.KeysDown[code] = pressed;
}

void setModifiers(ImGuiIO& io, bool control, bool shift, bool alt, bool super) {
  io.KeyCtrl = control;
  io.KeyShift = shift;
  io.KeyAlt = alt;
  io.KeySuper = super;
}

void setMousePosition(ImGuiIO& io, float x, float y) { io.MousePos = {x, y}; }
void setMouseButton(ImGuiIO& io, int button, bool pressed) { io.MouseDown[button] = pressed; }

void addScroll(ImGuiIO& io, float x, float y) {
  io.MouseWheelH += x;
  io.MouseWheel += y;
}

#endif

}  // namespace

ImGuiInput::ImGuiInput(Clipboard* clipboard) {
  prepare(ImGui::GetIO());
  ImGui::GetIO().KeyRepeatDelay = kAnyTime;              // the window says when a key repeats
  setMousePosition(ImGui::GetIO(), -FLT_MAX, -FLT_MAX);  // nowhere yet
  if (!clipboard) return;
  pasteboard_ = std::make_unique<Pasteboard>(Pasteboard{*clipboard, {}});
  static constexpr auto kGet = [](void* user) {
    auto& pasteboard = *static_cast<Pasteboard*>(user);
    pasteboard.pasted = pasteboard.clipboard.text();
    return pasteboard.pasted.c_str();
  };
  static constexpr auto kSet = [](void* user, const char* text) {
    static_cast<Pasteboard*>(user)->clipboard.setText(text);
  };
#if IMGUI_VERSION_NUM >= 19110
  ImGuiPlatformIO& io = ImGui::GetPlatformIO();
  io.Platform_ClipboardUserData = pasteboard_.get();
  io.Platform_GetClipboardTextFn = [](ImGuiContext*) {
    return kGet(ImGui::GetPlatformIO().Platform_ClipboardUserData);
  };
  io.Platform_SetClipboardTextFn = [](ImGuiContext*, const char* text) {
    kSet(ImGui::GetPlatformIO().Platform_ClipboardUserData, text);
  };
#else
  ImGuiIO& io = ImGui::GetIO();
  io.ClipboardUserData = pasteboard_.get();
  io.GetClipboardTextFn = [](void* user) { return kGet(user); };
  io.SetClipboardTextFn = [](void* user, const char* text) { kSet(user, text); };
#endif
}

ImGuiInput::~ImGuiInput() = default;

void ImGuiInput::releaseEverything() {
  ImGuiIO& io = ImGui::GetIO();
  for (const auto& [code, index] : heldKeys_) setKey(io, index, false);
  heldKeys_.clear();
  for (int button = 0; button < kMouseButtons; ++button) setMouseButton(io, button, false);
  setModifiers(io, false, false, false, false);
}

bool ImGuiInput::movesMouse(const WindowEvent& event) const {
  return event.x != mouseX_ || event.y != mouseY_;
}

bool ImGuiInput::canTake(const WindowEvent& event) const {
  switch (event.kind) {
    case Kind::mouseMove:
      return !clicked_ && !scrolled_ && changedKeys_.empty();
    case Kind::mouseButton:  // knows where it happened, so it is a move as well
      if (clicked_ || scrolled_ || !changedKeys_.empty()) return false;
      return event.pressed || (!moved_ && !movesMouse(event));  // a slider takes up the last move first
    case Kind::scroll:
      return !clicked_ && !scrolled_;
    case Kind::key:
      if (clicked_ || changedKeys_.contains(event.code)) return false;
      if (isModifier(event.code)) return !pressedKey_;
      return !event.pressed || !edited_;
    case Kind::character:
      return !clicked_ && !edited_;
    case Kind::focus:
      return !clicked_ && changedKeys_.empty();
    case Kind::resize:
      return true;
  }
  return true;
}

void ImGuiInput::take(const WindowEvent& event) {
  ImGuiIO& io = ImGui::GetIO();
  switch (event.kind) {
    case Kind::mouseMove:
      moved_ |= movesMouse(event);
      mouseX_ = event.x;
      mouseY_ = event.y;
      setMousePosition(io, static_cast<float>(event.x), static_cast<float>(event.y));
      break;
    case Kind::mouseButton:
      takeMouseButton(event);
      break;
    case Kind::scroll:
      addScroll(io, static_cast<float>(event.x), static_cast<float>(event.y));
      scrolled_ = true;
      break;
    case Kind::key:
      takeKey(event);
      break;
    case Kind::character:
      io.AddInputCharacter(event.character);
      break;
    case Kind::focus:
      if (!event.pressed) releaseEverything();
      break;
    case Kind::resize:
      break;
  }
}

void ImGuiInput::takeMouseButton(const WindowEvent& event) {
  if (event.code < 0 || event.code >= kMouseButtons) return;
  WindowEvent move = event;
  move.kind = Kind::mouseMove;
  take(move);
  ImGuiIO& io = ImGui::GetIO();
  if (event.pressed) {
    // Dear ImGui measures by its frames. What is known of the time decides instead: the shortest that it may
    // have been.
    const auto last = lastPressSeconds_.find(event.code);
    const bool soon =
        last != lastPressSeconds_.end() && event.earliestSeconds - last->second < ui::kDoubleClickSeconds;
    io.MouseDoubleClickTime = soon ? kAnyTime : 0;
    lastPressSeconds_[event.code] = event.latestSeconds;
  }
  setMouseButton(io, event.code, event.pressed);
  clicked_ = true;
}

void ImGuiInput::takeKey(const WindowEvent& event) {
  ImGuiIO& io = ImGui::GetIO();
  if (event.pressed) {
    // The letter of a key without one on this layout is nobody's.
    const bool isLetterPlace = event.code >= 'A' && event.code <= 'Z';
    heldKeys_[event.code] = event.letter ? event.letter : isLetterPlace ? -1 : event.code;
  }
  const auto held = heldKeys_.find(event.code);
  if (held != heldKeys_.end()) setKey(io, held->second, event.pressed);
  if (!event.pressed) heldKeys_.erase(event.code);
  const auto holds = [this](int left, int right) {
    return heldKeys_.contains(left) || heldKeys_.contains(right);
  };
  setModifiers(io, holds(key::kLeftControl, key::kRightControl), holds(key::kLeftShift, key::kRightShift),
               holds(key::kLeftAlt, key::kRightAlt), holds(key::kLeftSuper, key::kRightSuper));
  changedKeys_.insert(event.code);
  if (event.pressed && !isModifier(event.code)) {
    pressedKey_ = true;
    edited_ = edited_ || isEditingKey(event) || holds(key::kLeftControl, key::kRightControl);
  }
}

void ImGuiInput::frameBegan() {
  changedKeys_.clear();
  clicked_ = scrolled_ = moved_ = pressedKey_ = edited_ = false;
}

bool ImGuiInput::wantsText() { return ImGui::GetIO().WantTextInput; }

bool ImGuiInput::isEditingKey(const WindowEvent& event) {
  if (event.kind != Kind::key) return false;
  if ((event.modifiers & kControlModifier) != 0) return true;
  for (const KeyPair& pair : kKeys) {
    if (pair.code == event.code)
      return event.code != key::kSpace && !(event.code >= 'A' && event.code <= 'Z');
  }
  return false;
}

bool ImGuiInput::movesFocus(const WindowEvent& event) {
  if (event.kind == Kind::mouseButton) return true;
  if (event.kind != Kind::key) return false;
  for (const int code : {key::kTab, key::kEnter, key::kKeypadEnter, key::kEscape}) {
    if (event.code == code) return true;
  }
  return isMenuChord(event);
}

bool ImGuiInput::isMenuChord(const WindowEvent& event) {
  return event.kind == Kind::key && (event.modifiers & kControlModifier) != 0 &&
         (event.letter == 'F' || event.letter == 'Z' || event.letter == 'Y');
}

}  // namespace skydrop::app
