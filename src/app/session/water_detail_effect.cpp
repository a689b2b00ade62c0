#include "app/session/water_detail_effect.h"

#include "app/session/scene_renderer.h"
#include "skydrop/render/water/water_detail_pass.h"
#include "skydrop/render/water/water_mirror_pass.h"

namespace skydrop::app {

void addWaterDetail(SceneRenderer& sceneRenderer) {
  render::Renderer& renderer = sceneRenderer.renderer();
  const Settings& settings = sceneRenderer.settings();
  renderer.add(std::make_unique<render::SeaWavesPass>(settings.waterDetail, settings.wind));
  renderer.add(std::make_unique<render::WaterMirrorPass>(settings.waterDetail));
  renderer.add(std::make_unique<render::WaterReflectionPass>(settings.waterDetail));
}

void applyWaterDetail(SceneRenderer& sceneRenderer, const SettingsChange& change) {
  if (!change.touches("waterDetail") && !change.touches("wind")) return;
  render::Renderer& renderer = sceneRenderer.renderer();
  const Settings& settings = sceneRenderer.settings();
  renderer.find<render::SeaWavesPass>()->apply(settings.waterDetail, settings.wind);
  renderer.find<render::WaterMirrorPass>()->apply(settings.waterDetail);
  renderer.find<render::WaterReflectionPass>()->apply(settings.waterDetail);
}

}  // namespace skydrop::app
