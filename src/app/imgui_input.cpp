#include "app/imgui_input.h"

#include <imgui.h>

#include <cfloat>

#include "app/input_code.h"

namespace skydrop::app {
namespace {

using render::gl::WindowEvent;
using Kind = WindowEvent::Kind;

constexpr int kControlModifier = 0x0002;  // GLFW's
constexpr int kMouseButtons = 5;          // as many as Dear ImGui knows

#if IMGUI_VERSION_NUM >= 18900
constexpr ImGuiKey kImGuiKeypadEnter = ImGuiKey_KeypadEnter;
#else
constexpr ImGuiKey kImGuiKeypadEnter = ImGuiKey_KeyPadEnter;
#endif

struct KeyPair {
  int code;
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

#if IMGUI_VERSION_NUM >= 18900

void prepare(ImGuiIO&) {}

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

void ImGuiInput::handle(const WindowEvent& event, double pixelsPerUnit) {
  if (event.kind == Kind::resize || event.repeated) return;  // Dear ImGui repeats keys by itself
  WindowEvent inPixels = event;
  if (event.kind == Kind::mouseMove || event.kind == Kind::mouseButton) {
    inPixels.x *= pixelsPerUnit;
    inPixels.y *= pixelsPerUnit;
  }
  // A button event knows where it happened. The move before it also keeps two of them out of one frame.
  if (event.kind == Kind::mouseButton) {
    queue_.push_back(inPixels);
    queue_.back().kind = Kind::mouseMove;
  }
  queue_.push_back(inPixels);
}

void ImGuiInput::releaseEverything() {
  ImGuiIO& io = ImGui::GetIO();
  for (const int code : heldKeys_) setKey(io, code, false);
  heldKeys_.clear();
  for (int button = 0; button < kMouseButtons; ++button) setMouseButton(io, button, false);
  setModifiers(io, false, false, false, false);
}

// False if the event has to wait for the next frame.
bool ImGuiInput::apply(const WindowEvent& event) {
  ImGuiIO& io = ImGui::GetIO();
  switch (event.kind) {
    case Kind::mouseMove:
      if (clicked_ || !changedKeys_.empty() || scrolled_) return false;
      moved_ |= event.x != mouseX_ || event.y != mouseY_;
      mouseX_ = event.x;
      mouseY_ = event.y;
      setMousePosition(io, static_cast<float>(event.x), static_cast<float>(event.y));
      return true;
    case Kind::mouseButton:
      if (event.code < 0 || event.code >= kMouseButtons) return true;
      if (moved_ && !event.pressed) return false;  // a slider takes up the last move before it is let go
      setMouseButton(io, event.code, event.pressed);
      clicked_ = true;
      return true;
    case Kind::scroll:
      if (clicked_) return false;
      addScroll(io, static_cast<float>(event.x), static_cast<float>(event.y));
      scrolled_ = true;
      return true;
    case Kind::key:
      if (changedKeys_.contains(event.code) || clicked_) return false;
      if (event.pressed)
        heldKeys_.insert(event.code);
      else
        heldKeys_.erase(event.code);
      setKey(io, event.code, event.pressed);
      setModifiers(io, heldKeys_.contains(key::kLeftControl) || heldKeys_.contains(key::kRightControl),
                   heldKeys_.contains(key::kLeftShift) || heldKeys_.contains(key::kRightShift),
                   heldKeys_.contains(key::kLeftAlt) || heldKeys_.contains(key::kRightAlt),
                   heldKeys_.contains(key::kLeftSuper) || heldKeys_.contains(key::kRightSuper));
      changedKeys_.insert(event.code);
      return true;
    case Kind::character:
      io.AddInputCharacter(event.character);
      return true;
    case Kind::focus:
      if (!event.pressed) releaseEverything();
      return true;
    case Kind::resize:
      return true;
  }
  return true;
}

void ImGuiInput::beginFrame() {
  changedKeys_.clear();
  clicked_ = scrolled_ = moved_ = false;
  while (!queue_.empty() && apply(queue_.front())) queue_.pop_front();
}

bool ImGuiInput::wantsText() { return ImGui::GetIO().WantTextInput; }
bool ImGuiInput::isMenuChord(const WindowEvent& event) {
  return event.kind == Kind::key && (event.modifiers & kControlModifier) != 0 &&
         (event.code == 'F' || event.code == 'Z' || event.code == 'Y');
}

bool ImGuiInput::wantsMouse() { return ImGui::GetIO().WantCaptureMouse; }

}  // namespace skydrop::app
