#include "app/session/ground_fog_effect.h"

#include "app/session/scene_renderer.h"
#include "skydrop/render/fog/ground_fog_pass.h"

namespace skydrop::app {

void addGroundFog(SceneRenderer& sceneRenderer) {
  render::Renderer& renderer = sceneRenderer.renderer();
  renderer.add(
      std::make_unique<render::GroundFogPass>(renderer.context(), sceneRenderer.settings().groundFog));
}

void applyGroundFog(SceneRenderer& sceneRenderer, const SettingsChange& change) {
  if (!change.touches("groundFog")) return;
  sceneRenderer.renderer().find<render::GroundFogPass>()->apply(sceneRenderer.settings().groundFog);
}

}  // namespace skydrop::app
