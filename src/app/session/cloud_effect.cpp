#include "app/session/cloud_effect.h"

#include "app/session/cloud_noise.h"
#include "app/session/scene_renderer.h"
#include "skydrop/render/clouds/cloud_shade_pass.h"

namespace skydrop::app {

void addClouds(SceneRenderer& sceneRenderer) {
  render::Renderer& renderer = sceneRenderer.renderer();
  renderer.add(std::make_unique<render::CloudSystem>(
      renderer.context(), sceneRenderer.prepared().find<clouds::PackedCloudNoise>(),
      sceneRenderer.settings().clouds, sceneRenderer.settings().wind));
}

void addCloudShadows(SceneRenderer& sceneRenderer) {
  render::Renderer& renderer = sceneRenderer.renderer();
  renderer.add(std::make_unique<render::CloudShadowPass>(*renderer.find<render::CloudSystem>()));
}

void removeCloudShadows(SceneRenderer& sceneRenderer) {
  sceneRenderer.renderer().find<render::CloudSystem>()->forgetShadowMap();
}

void addCloudShade(SceneRenderer& sceneRenderer) {
  render::Renderer& renderer = sceneRenderer.renderer();
  renderer.add(std::make_unique<render::CloudShadePass>(*renderer.find<render::CloudSystem>()));
}

void applyClouds(SceneRenderer& sceneRenderer, const SettingsChange& change) {
  if (!change.touches("clouds") && !change.touches("wind")) return;
  const Settings& settings = sceneRenderer.settings();
  sceneRenderer.renderer().find<render::CloudSystem>()->apply(settings.clouds, settings.wind);
}

std::unique_ptr<Preparation> prepareClouds(Preparation::Maker maker, const Settings&) {
  return std::make_unique<CloudNoise>(NoiseStore(cacheFolder()), maker);
}

}  // namespace skydrop::app
