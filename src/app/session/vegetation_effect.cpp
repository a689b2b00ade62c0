#include "app/session/vegetation_effect.h"

#include "app/session/ground.h"
#include "app/session/scene_renderer.h"
#include "skydrop/render/vegetation/vegetation_pass.h"

namespace skydrop::app {
namespace {

std::shared_ptr<const terrain::Woods> woodsOf(const SceneRenderer& sceneRenderer) {
  const std::shared_ptr<const terrain::HeightSource>& ground = sceneRenderer.setup().ground;
  return std::make_shared<const terrain::Woods>(ground, sceneRenderer.settings().woods.density,
                                                hasAlpineBelts(*ground));
}

}  // namespace

void addVegetation(SceneRenderer& sceneRenderer) {
  render::Renderer& renderer = sceneRenderer.renderer();
  const Settings& settings = sceneRenderer.settings();
  renderer.add(std::make_unique<render::WoodFloorPass>(settings.vegetation, settings.woods.density));
  renderer.add(std::make_unique<render::VegetationPass>(renderer.context(), woodsOf(sceneRenderer),
                                                        settings.vegetation));
}

void applyVegetation(SceneRenderer& sceneRenderer, const SettingsChange& change) {
  if (!change.touches("vegetation") && !change.touches("woods")) return;
  render::Renderer& renderer = sceneRenderer.renderer();
  const Settings& settings = sceneRenderer.settings();
  renderer.find<render::WoodFloorPass>()->apply(settings.vegetation, settings.woods.density);
  renderer.find<render::VegetationPass>()->apply(woodsOf(sceneRenderer), settings.vegetation);
}

}  // namespace skydrop::app
