// The owner of the Dear ImGui context that HUD and menus draw into: font, scale and style. It knows no window
// and no OpenGL: the size and the time of each frame are passed in, nothing is read from or written to disk,
// so a frame of the interface is a pure function of what it was given. render::ImGuiPass draws the result;
// whoever has a window feeds ImGui's io (app/input/imgui_input.h). One at a time, main thread.
//
// Dear ImGui's windows find their size in the first frame that shows them: for a single picture of a menu run
// beginFrame, the menu, endFrame twice and draw the second.
#pragma once

#include <memory>

struct ImDrawData;
struct ImFont;
struct ImGuiContext;

namespace skydrop::ui {

// Two presses of a mouse button no further apart are a double click, in seconds.
inline constexpr double kDoubleClickSeconds = 0.3;

// Pixels from the top left corner of the window.
struct ScreenRect {
  float left = 0, top = 0, right = 0, bottom = 0;
};

// One size of the typeface. The halo of a text is drawn first, dark, at the same place: it keeps the text
// readable over bright ground.
struct Typeface {
  ImFont* face = nullptr;
  ImFont* halo = nullptr;
  float pixels = 0;  // height of a line
};

// How large texts are.
struct InterfaceScale {
  double factor = 1;   // the player's wish, [.5, 3]
  double density = 1;  // of the screen, >= 1: the smallest text has that many times the pixels
};

class Interface {
 public:
  // The size in pixels of what is drawn into. It decides the scale.
  Interface(int width, int height, const InterfaceScale& scale = {});
  ~Interface();
  Interface(const Interface&) = delete;
  Interface& operator=(const Interface&) = delete;

  // The Dear ImGui context that input goes to, again: after another interface has been there, which must be
  // gone.
  void makeCurrent() const;

  // Starts a frame. `seconds` since the last one: 0 (pause, single frames) is allowed; it is clamped to
  // [1e-6, 0.25]. True if the font atlas changed because of the size: render::ImGuiPass::uploadFonts() is due
  // before the frame is drawn.
  [[nodiscard]] bool beginFrame(int width, int height, double seconds, const InterfaceScale& scale = {});
  // Ends it. Owned by Dear ImGui, valid until the next beginFrame().
  ImDrawData* endFrame();

  int width() const { return width_; }
  int height() const { return height_; }
  // The line height that a window of this size gets, in pixels: about a fortieth of its height, times the
  // scale, but never so large that the interface would not fit.
  static int linePixels(int width, int height, const InterfaceScale& scale = {});

  const Typeface& text() const { return text_; }
  const Typeface& large() const { return large_; }  // twice as high; ASCII only

 private:
  void rebuildFonts(int linePixels);

  struct ContextDeleter {
    void operator()(ImGuiContext* context) const;
  };
  std::unique_ptr<ImGuiContext, ContextDeleter> context_;
  int width_, height_;
  Typeface text_, large_;
};

}  // namespace skydrop::ui
