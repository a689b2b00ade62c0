// The window's events on their way to their readers, in the order in which they came: first whoever flies,
// then the interface. Which of them an event is meant for may depend on the one before it (the click that
// opens a text field, the key that opens the menu), and Dear ImGui sees one state of mouse and keys in a
// frame: where events need it, frames of the interface are built between them that nobody sees, so what a
// player does takes effect the same way at any frame rate. Main thread.
#pragma once

#include <deque>
#include <functional>

#include "app/input/imgui_input.h"

namespace skydrop::app {

class EventFeed {
 public:
  // Frames of the interface that one call of deliver() builds at most; what is left waits for the next call.
  static constexpr int kMostFrames = 48;
  // Frames until a click or a key has moved the keyboard to the text field that it opens.
  static constexpr int kFramesToSettle = 5;

  // The input must outlive this.
  explicit EventFeed(ImGuiInput& input) : input_(&input) {}

  struct Readers {
    std::function<bool(const render::gl::WindowEvent&)> first;  // true: nobody else gets it
    std::function<bool()> interfaceOpen;                        // a menu is open that events may be meant for
    std::function<void()> buildFrame;                           // builds a frame, and calls frameBuilt()
  };

  // pixelsPerUnit: pixels of the frame buffer in a window coordinate, 1 except on some high-density screens.
  void add(const render::gl::WindowEvent& event, double pixelsPerUnit = 1);
  // Not for the first reader.
  void addForInterface(const render::gl::WindowEvent& event);

  void deliver(const Readers& readers);
  // After every frame of the interface, those that are shown included.
  void frameBuilt();

  bool empty() const { return waiting_.empty(); }

 private:
  struct Waiting {
    render::gl::WindowEvent event;
    bool forFirst;
  };
  bool isReady(const render::gl::WindowEvent& event, bool open) const;
  void handOver(const Waiting& next, const Readers& readers, bool open);

  ImGuiInput* input_;
  std::deque<Waiting> waiting_;  // mouse positions in pixels
  bool wasOpen_ = false;
  int framesSinceOpening_ = kFramesToSettle;  // or closing
  int framesSinceFocus_ = kFramesToSettle;    // since something that may have moved the keyboard
};

}  // namespace skydrop::app
