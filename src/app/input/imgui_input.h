// Hands the window's events to Dear ImGui, in place of its GLFW back-end: plain data in, so tests drive the
// menus by the same path. A frame of the interface takes no event that would hide another one (a press and
// its release, a click and the move after it, two keys that edit a text): EventFeed gives it as many frames
// as the events need, so nothing is lost at low frame rates. Main thread.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>

#include "skydrop/render/platform/window_context.h"

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

  // Whether the next frame of the interface can take the event; else it has to wait for the one after it.
  // Mouse positions are pixels of the frame buffer.
  bool canTake(const render::gl::WindowEvent& event) const;
  // Takes it whatever it may hide. Two presses of a mouse button are a double click when, by the times of the
  // events, they may lie within ui::kDoubleClickSeconds, whatever the frames between them took.
  void take(const render::gl::WindowEvent& event);
  // A frame of the interface has begun (Interface::beginFrame) and has seen everything that was taken.
  void frameBegan();

  // A text field takes the keyboard.
  static bool wantsText();
  // Whether the key edits a text field or leaves it, rather than only type into it.
  static bool isEditingKey(const render::gl::WindowEvent& event);
  // Whether it may move the keyboard to or from a text field.
  static bool movesFocus(const render::gl::WindowEvent& event);
  // Ctrl with F, Z or Y: the open menu's (search, undo, redo), whatever these letters are bound to.
  static bool isMenuChord(const render::gl::WindowEvent& event);

 private:
  void takeMouseButton(const render::gl::WindowEvent& event);
  void takeKey(const render::gl::WindowEvent& event);
  void releaseEverything();
  bool movesMouse(const render::gl::WindowEvent& event) const;

  struct Pasteboard {
    Clipboard& clipboard;
    std::string pasted;  // Dear ImGui keeps a pointer into it
  };
  std::unique_ptr<Pasteboard> pasteboard_;

  std::map<int, int> heldKeys_;  // by place: the index under which Dear ImGui knows it, -1 for none
  std::map<int, double> lastPressSeconds_;  // of each mouse button
  // What the next frame will see.
  std::set<int> changedKeys_;
  bool clicked_ = false, scrolled_ = false, moved_ = false;
  bool pressedKey_ = false, edited_ = false;
  double mouseX_ = 0, mouseY_ = 0;  // pixels
};

}  // namespace skydrop::app
