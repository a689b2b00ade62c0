// The clipboard of the desktop, by way of a window. The window must outlive it. Main thread.
#pragma once

#include <string>

#include "app/input/imgui_input.h"
#include "skydrop/render/platform/window_context.h"

namespace skydrop::app {

class WindowClipboard final : public Clipboard {
 public:
  explicit WindowClipboard(render::gl::WindowContext& window) : window_(window) {}
  std::string text() override { return window_.clipboardText(); }
  void setText(const std::string& text) override { window_.setClipboardText(text); }

 private:
  render::gl::WindowContext& window_;
};

}  // namespace skydrop::app
