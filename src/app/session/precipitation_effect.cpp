#include "app/session/precipitation_effect.h"

#include "app/session/scene_renderer.h"
#include "skydrop/render/precipitation/precipitation_pass.h"
#include "skydrop/render/precipitation/rain_map.h"
#include "skydrop/render/precipitation/rain_veil_pass.h"
#include "skydrop/render/precipitation/splash_pass.h"
#include "skydrop/render/precipitation/wet_ground_pass.h"

namespace skydrop::app {

void addPrecipitation(SceneRenderer& sceneRenderer) {
  render::Renderer& renderer = sceneRenderer.renderer();
  const render::PrecipitationSettings& settings = sceneRenderer.settings().precipitation;
  renderer.add(std::make_unique<render::RainVeilPass>(renderer.context(), settings));
  renderer.add(std::make_unique<render::PrecipitationPass>(renderer.context(), settings));
}

void addPrecipitationFeatures(render::FrameFeatures& features) { features.fallenWater = true; }

void addRainMap(SceneRenderer& sceneRenderer) {
  render::Renderer& renderer = sceneRenderer.renderer();
  const Settings& settings = sceneRenderer.settings();
  renderer.add(std::make_unique<render::RainMapPass>(
      renderer.context(), *sceneRenderer.prepared().find<clouds::PackedCloudNoise>(), settings.wind));
}

void addFallenWater(SceneRenderer& sceneRenderer) {
  render::Renderer& renderer = sceneRenderer.renderer();
  const render::PrecipitationSettings& settings = sceneRenderer.settings().precipitation;
  renderer.add(std::make_unique<render::WetGroundPass>(settings));
  renderer.add(std::make_unique<render::SplashPass>(renderer.context(), settings));
}

void applyPrecipitation(SceneRenderer& sceneRenderer, const SettingsChange& change) {
  render::Renderer& renderer = sceneRenderer.renderer();
  const Settings& settings = sceneRenderer.settings();
  if (auto* map = renderer.find<render::RainMapPass>()) map->apply(settings.wind);
  if (!change.touches("precipitation")) return;
  renderer.find<render::RainVeilPass>()->apply(settings.precipitation);
  renderer.find<render::PrecipitationPass>()->apply(settings.precipitation);
  if (auto* ground = renderer.find<render::WetGroundPass>()) ground->apply(settings.precipitation);
  if (auto* splashes = renderer.find<render::SplashPass>()) splashes->apply(settings.precipitation);
}

}  // namespace skydrop::app
