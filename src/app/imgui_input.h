// Hands the window's events to Dear ImGui, in place of its GLFW back-end: plain data in, so tests drive the
// menus by the same path. Events that would hide each other within one frame (a press and its release, a
// click and the move after it) are spread over frames, so nothing is lost at low frame rates. Main thread.
#pragma once

#include <deque>
#include <memory>
#include <set>
#include <string>

#include "skydrop/render/gl/window_context.h"

namespace skydrop::app {

// What is cut, copied and pasted in text fields: the window's, or a test's. UTF-8.
class Clipboard {
 public:
  virtual ~Clipboard() = default;
  virtual std::string text() = 0;
  virtual void setText(const std::string& text) = 0;
};

class ImGuiInput {
 public:
  // For the current Dear ImGui context, which must exist (ui::Interface) and outlive this, as must the
  // clipboard. Without one, Dear ImGui keeps a clipboard of its own.
  explicit ImGuiInput(Clipboard* clipboard = nullptr);
  ~ImGuiInput();
  ImGuiInput(const ImGuiInput&) = delete;
  ImGuiInput& operator=(const ImGuiInput&) = delete;

  // pixelsPerUnit: pixels of the frame buffer in a window coordinate, 1 except on some high-density screens.
  void handle(const render::gl::WindowEvent& event, double pixelsPerUnit = 1);

  // Before Interface::beginFrame, once a frame.
  void beginFrame();

  // A text field takes the keyboard.
  static bool wantsText();
  // Ctrl with F, Z or Y: the open menu's (search, undo, redo), whatever these letters are bound to.
  static bool isMenuChord(const render::gl::WindowEvent& event);
  // The mouse is over the interface, or holds one of its widgets.
  static bool wantsMouse();

 private:
  bool apply(const render::gl::WindowEvent& event);
  void releaseEverything();

  struct Pasteboard {
    Clipboard& clipboard;
    std::string pasted;  // Dear ImGui keeps a pointer into it
  };
  std::unique_ptr<Pasteboard> pasteboard_;

  std::deque<render::gl::WindowEvent> queue_;  // mouse positions already in pixels
  std::set<int> heldKeys_;
  // What this frame has already seen.
  std::set<int> changedKeys_;
  bool clicked_ = false, scrolled_ = false, moved_ = false;
  double mouseX_ = 0, mouseY_ = 0;  // pixels
};

}  // namespace skydrop::app
