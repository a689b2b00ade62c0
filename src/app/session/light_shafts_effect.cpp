#include "app/session/light_shafts_effect.h"

#include "app/session/scene_renderer.h"
#include "skydrop/render/shafts/light_shaft_pass.h"

namespace skydrop::app {

void addLightShafts(SceneRenderer& sceneRenderer) {
  sceneRenderer.renderer().add(
      std::make_unique<render::LightShaftPass>(sceneRenderer.settings().lightShafts));
}

void applyLightShafts(SceneRenderer& sceneRenderer, const SettingsChange& change) {
  if (!change.touches("lightShafts")) return;
  sceneRenderer.renderer().find<render::LightShaftPass>()->apply(sceneRenderer.settings().lightShafts);
}

}  // namespace skydrop::app
