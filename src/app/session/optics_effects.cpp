#include "app/session/optics_effects.h"

#include "app/session/scene_renderer.h"
#include "skydrop/render/sky/halo_pass.h"
#include "skydrop/render/sky/rainbow_pass.h"

namespace skydrop::app {

void addHalo(SceneRenderer& sceneRenderer) {
  render::Renderer& renderer = sceneRenderer.renderer();
  renderer.add(std::make_unique<render::HaloPass>(renderer.context(), sceneRenderer.settings().halo));
}

void applyHalo(SceneRenderer& sceneRenderer, const SettingsChange& change) {
  if (!change.touches("halo")) return;
  sceneRenderer.renderer().find<render::HaloPass>()->apply(sceneRenderer.settings().halo);
}

void addRainbow(SceneRenderer& sceneRenderer) {
  render::Renderer& renderer = sceneRenderer.renderer();
  renderer.add(std::make_unique<render::RainbowPass>(renderer.context(), sceneRenderer.settings().rainbow));
}

void applyRainbow(SceneRenderer& sceneRenderer, const SettingsChange& change) {
  if (!change.touches("rainbow")) return;
  sceneRenderer.renderer().find<render::RainbowPass>()->apply(sceneRenderer.settings().rainbow);
}

}  // namespace skydrop::app
