#include "app/window/loading_screen.h"

#include <algorithm>

namespace skydrop::app {
namespace {

constexpr double kFramesASecond = 60;  // the cores are for the land

}  // namespace

LoadingScreen::LoadingScreen(GameWindow& window, Overlay& overlay)
    : window_(window), overlay_(overlay), renderer_(window.context(), {}, false) {
  auto pass = std::make_unique<render::ImGuiPass>(window.context());
  pass_ = pass.get();
  renderer_.add(std::move(pass));
}

void LoadingScreen::show(ui::LoadingProgress progress) {
  progress.share = share_ = std::max(share_, progress.share);
  const Size size = window_.size();
  if (overlay_.buildLoading(size, progress, window_.interfaceScale())) pass_->uploadFonts();
  render::View view;
  view.width = size.width;
  view.height = size.height;
  renderer_.draw({.view = view});
  renderer_.present(size.width, size.height);
  window_.swap();
  pacer_.wait(kFramesASecond);
}

}  // namespace skydrop::app
