#include "app/session/ice_clouds_effect.h"

#include "app/session/scene_renderer.h"
#include "skydrop/render/clouds/ice_clouds_pass.h"
#include "skydrop/render/clouds/ice_shade_pass.h"
#include "skydrop/render/sky/halo_pass.h"

namespace skydrop::app {

void addIceClouds(SceneRenderer& sceneRenderer) {
  render::Renderer& renderer = sceneRenderer.renderer();
  const Settings& settings = sceneRenderer.settings();
  renderer.add(
      std::make_unique<render::IceCloudsPass>(renderer.context(), settings.iceClouds, settings.wind));
}

void addIceShade(SceneRenderer& sceneRenderer) {
  render::Renderer& renderer = sceneRenderer.renderer();
  renderer.add(std::make_unique<render::IceShadePass>(renderer.context(),
                                                      renderer.find<render::IceCloudsPass>()->layers()));
}

void addIceHalo(SceneRenderer& sceneRenderer) {
  auto* halo = sceneRenderer.renderer().find<render::HaloPass>();
  halo->leaveToClouds(true);
  sceneRenderer.renderer().find<render::IceCloudsPass>()->takeHalo(&halo->tables());
}

void removeIceHalo(SceneRenderer& sceneRenderer) {
  if (auto* halo = sceneRenderer.renderer().find<render::HaloPass>()) halo->leaveToClouds(false);
  if (auto* ice = sceneRenderer.renderer().find<render::IceCloudsPass>()) ice->takeHalo(nullptr);
}

void applyIceClouds(SceneRenderer& sceneRenderer, const SettingsChange& change) {
  if (!change.touches("iceClouds") && !change.touches("wind")) return;
  const Settings& settings = sceneRenderer.settings();
  sceneRenderer.renderer().find<render::IceCloudsPass>()->apply(settings.iceClouds, settings.wind);
}

}  // namespace skydrop::app
