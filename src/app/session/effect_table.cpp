#include "app/session/effect_table.h"

#include "app/session/scene_renderer.h"
#include "skydrop/core/assets.h"
#include "skydrop/render/models/aircraft_pass.h"
#include "skydrop/render/models/marker_pass.h"
#include "skydrop/render/models/package_pass.h"
#include "skydrop/render/sky/sky_pass.h"

namespace skydrop::app {
namespace {

using scene::Effect;

void addSky(SceneRenderer& sceneRenderer) {
  sceneRenderer.renderer().add(std::make_unique<render::SkyPass>(sceneRenderer.renderer().context()));
}

void addAircraft(SceneRenderer& sceneRenderer) {
  render::Renderer& renderer = sceneRenderer.renderer();
  const auto model = std::make_shared<const render::Model>(
      renderer.context(), render::importModel(core::assetPath("models/airplane.glb")), "airplane");
  renderer.add(std::make_unique<render::AircraftPass>(model));
  renderer.add(std::make_unique<render::PropellerPass>(model));
  sceneRenderer.castShadow(render::aircraftShadow(model));
}

void addTargets(SceneRenderer& sceneRenderer) {
  render::Renderer& renderer = sceneRenderer.renderer();
  const auto models = std::make_shared<const render::PackageModels>(renderer.context());
  renderer.add(std::make_unique<render::PackagePass>(models));
  sceneRenderer.castShadow(render::packageShadows(models));
  renderer.add(std::make_unique<render::MarkerPass>(renderer.context()));
}

void addLand(SceneRenderer& sceneRenderer) { sceneRenderer.addLand(); }

void addClouds(SceneRenderer& sceneRenderer) { sceneRenderer.addClouds(); }

void addHaze(render::FrameFeatures& features) { features.haze = true; }

}  // namespace

const std::vector<EffectDescriptor>& effectTable() {
  static const std::vector<EffectDescriptor> all = {
      {Effect::aircraft, addAircraft, nullptr, {{"aircraft", "Aircraft", true}, {"autopilot", "Autopilot"}}},
      {Effect::targets, addTargets, nullptr, {{"game", "Game"}, {"package", "Package"}}},
      {Effect::clouds,
       addClouds,
       nullptr,
       {{"clouds", "Weather", false, {"wind"}}, {"clouds.march", "Cloud quality"}}},
      {Effect::terrain,
       addLand,
       nullptr,
       {{"render.land", "Views of the land"},
        {"streaming", "Terrain LOD"},
        {"terrain", "Shape of the land"}}},
      {Effect::sky, addSky, nullptr, {{"render.sun", "Sun"}}},
      {Effect::haze, nullptr, addHaze, {{"render.atmosphere", "Air"}}},
      {Effect::sound, nullptr, nullptr, {{"audio", "Sound"}}},
      {Effect::hud, nullptr, nullptr, {}},
  };
  return all;
}

std::vector<ui::MenuSection> menuSections(const scene::EffectSet& effects) {
  std::vector<ui::MenuSection> sections;
  for (const EffectDescriptor& row : effectTable()) {
    if (!effects.contains(row.effect)) continue;
    sections.insert(sections.end(), row.menuSections.begin(), row.menuSections.end());
  }
  sections.insert(sections.end(), {{"", "Quality"},
                                   {"render.picture", "Picture"},
                                   {"render.camera", "Cameras"},
                                   {"view", "View"},
                                   {"input.gamepad", "Gamepad"}});
  return sections;
}

render::FrameFeatures frameFeatures(const scene::EffectSet& effects) {
  render::FrameFeatures features;
  for (const EffectDescriptor& row : effectTable()) {
    if (row.addFeatures && effects.contains(row.effect)) row.addFeatures(features);
  }
  return features;
}

}  // namespace skydrop::app
