// A window with a GL 4.5 core context. GLFW stays behind this class; its event values come through as plain
// data. Main thread only.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "skydrop/render/gl/context.h"

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

// What the desktop adds around the content: title and borders.
struct WindowFrame {
  int left = 0, top = 0, right = 0, bottom = 0;
};

// One thing that the user did. Codes of keys, buttons and modifiers are GLFW's (GLFW/glfw3.h).
struct WindowEvent {
  enum class Kind { key, mouseButton, mouseMove, scroll, character, focus, resize };
  Kind kind = Kind::key;
  int code = 0;          // key or button; a key's is its place, named by what an American keyboard has there
  int scanCode = 0;      // key
  char letter = '\0';    // key: the capital letter, A to Z, that the player's keyboard has there, or none
  bool pressed = false;  // key, button; focus: gained
  bool repeated = false;
  int modifiers = 0;
  unsigned character = 0;  // Unicode
  double x = 0, y = 0;     // mouse position in window coordinates, scroll offset, or new size in pixels
  // It happened between these, in seconds of one clock: since the events were last asked for. A slow frame
  // makes them lie far apart.
  double earliestSeconds = 0, latestSeconds = 0;
};

// The letter of a key whose layout names it `name` (null: nothing printable). Shortcuts go by it. A layout
// without Latin letters, and a key without a name, have the letter of the key's place.
char letterOfKey(int code, const char* name);

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
  void setPointerVisible(bool visible);

  // The system's clipboard, UTF-8; empty where it holds no text.
  std::string clipboardText() const;
  void setClipboardText(const std::string& text);

  void show();
  // Nobody sees what is drawn: minimised, or not shown.
  bool isHidden() const;
  // Where it stands, or would stand without full screen.
  WindowRect rect() const;
  WindowFrame frame() const;
  // What the desktop leaves free on each screen, the primary one first.
  std::vector<WindowRect> screens() const;
  void setSize(int width, int height);
  void setPosition(int left, int top);
  // How much larger text is wanted on the window's monitor than on a usual one: 1, 2 on many dense screens.
  double contentScale() const;
  // Sleeps until something happens, at most so long.
  void waitEvents(double seconds);

  // Handles what has arrived and returns it in order.
  std::vector<WindowEvent> pollEvents();

  struct Impl;

 protected:
  Procedure procAddress(const char* name) override;
  bool bindToThread() override;
  void releaseFromThread() override;

 private:
  std::unique_ptr<Impl> impl_;
};

}  // namespace skydrop::render::gl
