#include "app/window/loading.h"

#include <cmath>
#include <string>
#include <utility>

namespace skydrop::app {
namespace {

constexpr double kShareOfPreparations = 0.25;  // of the bar

}  // namespace

Loading::Loading(GameWindow& window, Overlay& overlay, std::function<bool()> goesOn)
    : window_(window), goesOn_(std::move(goesOn)), screen_(window, overlay) {
  screen_.show({"Getting ready", 0});
}

bool Loading::prepare(Preparations& preparations) {
  while (const Preparation* pending = preparations.pending()) {
    if (!goesOn_()) return false;
    preparations.makeParts(window_.context());
    screen_.show(
        {std::string(pending->title()) + ": " + std::to_string(std::lround(100 * pending->progress())) + " %",
         kShareOfPreparations * preparations.progress()});
  }
  return true;
}

void Loading::makeLand(SceneRenderer& sceneRenderer, const game::Snapshot& start) {
  sceneRenderer.load(start, window_.size());  // the workers begin with what is seen first, then the shaders
  sceneRenderer.warmUp(start, window_.size());
  while (goesOn_()) {
    const SceneRenderer::LandProgress land = sceneRenderer.load(start, window_.size());
    const double share =
        land.wanted > 0 ? static_cast<double>(land.ready) / static_cast<double>(land.wanted) : 1;
    screen_.show(
        {"Making the land: " + std::to_string(land.ready) + " of " + std::to_string(land.wanted), share});
    if (land.complete) break;
  }
}

}  // namespace skydrop::app
