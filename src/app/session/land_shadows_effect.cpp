#include "app/session/land_shadows_effect.h"

#include "app/session/scene_renderer.h"
#include "skydrop/render/shadows/land_shadow_pass.h"

namespace skydrop::app {

void addLandShadows(SceneRenderer& sceneRenderer) {
  sceneRenderer.renderer().add(std::make_unique<render::LandShadowPass>(
      sceneRenderer.setup().ground, sceneRenderer.settings().landShadows));
}

void addLandShadowFeatures(render::FrameFeatures& features) { features.landShadows = true; }

void applyLandShadows(SceneRenderer& sceneRenderer, const SettingsChange& change) {
  if (!change.touches("landShadows")) return;
  sceneRenderer.renderer().find<render::LandShadowPass>()->apply(sceneRenderer.settings().landShadows);
}

}  // namespace skydrop::app
