// A window with a GL 4.5 core context. GLFW stays behind this class; its event values come through as plain
// data. Main thread only.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "skydrop/render/gl/context.h"

struct GLFWwindow;

namespace skydrop::render::gl {

struct WindowSettings {
  int width = 1280, height = 720;
  std::string title = "Skydrop";
  bool fullScreen = false;
  bool visible = true;  // false: `skydrop render --backend window`
};

// Where a window stands that does not fill the screen: its content, in window coordinates.
struct WindowRect {
  int left = 0, top = 0, width = 0, height = 0;
};

// One thing that the user did. Codes of keys, buttons and modifiers are GLFW's (GLFW/glfw3.h).
struct WindowEvent {
  enum class Kind { key, mouseButton, mouseMove, scroll, character, focus, resize };
  Kind kind = Kind::key;
  int code = 0;          // key or button
  int scanCode = 0;      // key
  bool pressed = false;  // key, button; focus: gained
  bool repeated = false;
  int modifiers = 0;
  unsigned character = 0;  // Unicode
  double x = 0, y = 0;     // mouse position in window coordinates, scroll offset, or new size in pixels
};

class WindowContext final : public Context {
 public:
  // Throws core::GraphicsUnavailable without a display or without GL 4.5 core.
  explicit WindowContext(const WindowSettings& settings);
  ~WindowContext() override;

  // Size in pixels of what is drawn into (the default frame buffer), at least 1.
  int width() const;
  int height() const;

  // Pixels in a window coordinate, in which the mouse is told: 1, more on some high-density screens.
  double pixelsPerUnit() const;

  bool shouldClose() const;
  void setShouldClose(bool close);
  void swap();
  void setVsync(bool on);
  bool isFullScreen() const;
  // Full screen on the monitor that holds the window's centre; back to the old place and size.
  void setFullScreen(bool on);
  bool isFocused() const;
  void setPointerVisible(bool visible);

  // The system's clipboard, UTF-8; empty where it holds no text.
  std::string clipboardText() const;
  void setClipboardText(const std::string& text);

  void show();
  // Nobody sees what is drawn: minimised, or not shown.
  bool isHidden() const;
  // Where it stands, or would stand without full screen.
  WindowRect rect() const;
  void setSize(int width, int height);
  // Ignored where the window's title would lie outside of all screens.
  void setPosition(int left, int top);
  // How much larger text is wanted on the window's monitor than on a usual one: 1, 2 on many dense screens.
  double contentScale() const;
  // Sleeps until something happens, at most so long.
  void waitEvents(double seconds);

  // Handles what has arrived and returns it in order.
  std::vector<WindowEvent> pollEvents();
  bool isKeyDown(int key) const;

  // For Dear ImGui's GLFW back-end, which chains its callbacks to ours.
  GLFWwindow* handle() const;

  struct Impl;

 protected:
  Procedure procAddress(const char* name) override;
  bool bindToThread() override;
  void releaseFromThread() override;

 private:
  std::unique_ptr<Impl> impl_;
};

}  // namespace skydrop::render::gl
