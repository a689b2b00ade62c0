#include "app/session/ground_cover_effect.h"

#include "app/session/scene_renderer.h"
#include "skydrop/render/ground_cover/ground_cover_pass.h"

namespace skydrop::app {

void addGroundCover(SceneRenderer& sceneRenderer) {
  render::Renderer& renderer = sceneRenderer.renderer();
  renderer.add(std::make_unique<render::GroundCoverPass>(renderer.context(), sceneRenderer.setup().ground,
                                                         sceneRenderer.settings().groundCover));
}

void applyGroundCover(SceneRenderer& sceneRenderer, const SettingsChange& change) {
  if (!change.touches("groundCover")) return;
  sceneRenderer.renderer().find<render::GroundCoverPass>()->apply(sceneRenderer.settings().groundCover);
}

}  // namespace skydrop::app
