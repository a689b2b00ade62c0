#include "app/session/dust_and_spray_effect.h"

#include "app/session/scene_renderer.h"
#include "skydrop/render/spray/spray_pass.h"
#include "skydrop/render/spray/wake_pass.h"

namespace skydrop::app {

void addDustAndSpray(SceneRenderer& sceneRenderer) {
  render::Renderer& renderer = sceneRenderer.renderer();
  const render::DustAndSpraySettings& settings = sceneRenderer.settings().dustAndSpray;
  renderer.add(std::make_unique<render::WakePass>(renderer.context(), settings));
  renderer.add(std::make_unique<render::SprayPass>(renderer.context(), settings));
}

void applyDustAndSpray(SceneRenderer& sceneRenderer, const SettingsChange& change) {
  if (!change.touches("dustAndSpray")) return;
  render::Renderer& renderer = sceneRenderer.renderer();
  const render::DustAndSpraySettings& settings = sceneRenderer.settings().dustAndSpray;
  renderer.find<render::WakePass>()->apply(settings);
  renderer.find<render::SprayPass>()->apply(settings);
}

}  // namespace skydrop::app
