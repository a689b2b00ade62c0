// The picture while land, models and shaders are prepared: shown before anything else is built, so it draws
// with a renderer of its own that has nothing but the interface. Main thread.
#pragma once

#include "app/window/game_window.h"
#include "app/window/overlay.h"
#include "skydrop/render/frame/renderer.h"
#include "skydrop/render/overlay/imgui_pass.h"

namespace skydrop::app {

class LoadingScreen {
 public:
  // Both must outlive it. When it goes it takes its fonts along: SceneRenderer::uploadFonts() is due.
  LoadingScreen(GameWindow& window, Overlay& overlay);

  // Draws and shows it. The bar never goes back.
  void show(ui::LoadingProgress progress);

 private:
  GameWindow& window_;
  Overlay& overlay_;
  render::Renderer renderer_;
  render::ImGuiPass* pass_;  // the renderer's
  FramePacer pacer_;
  double share_ = 0;
};

}  // namespace skydrop::app
