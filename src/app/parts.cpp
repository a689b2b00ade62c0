#include "app/parts.h"

#include "app/stage.h"
#include "skydrop/core/assets.h"
#include "skydrop/render/aircraft_pass.h"
#include "skydrop/render/marker_pass.h"
#include "skydrop/render/package_pass.h"
#include "skydrop/render/sky_pass.h"

namespace skydrop::app {
namespace {

using scene::Effect;

void addSky(Stage& stage) {
  stage.renderer().add(std::make_unique<render::SkyPass>(stage.renderer().context()));
}

void addAircraft(Stage& stage) {
  render::Renderer& renderer = stage.renderer();
  const auto model = std::make_shared<const render::Model>(
      renderer.context(), render::importModel(core::assetPath("models/airplane.glb")), "airplane");
  renderer.add(std::make_unique<render::AircraftPass>(model));
  renderer.add(std::make_unique<render::PropellerPass>(model));
  stage.castShadow(render::aircraftShadow(model));
}

void addTargets(Stage& stage) {
  render::Renderer& renderer = stage.renderer();
  const auto models = std::make_shared<const render::PackageModels>(renderer.context());
  renderer.add(std::make_unique<render::PackagePass>(models));
  stage.castShadow(render::packageShadows(models));
  renderer.add(std::make_unique<render::MarkerPass>(renderer.context()));
}

void addLand(Stage& stage) { stage.addLand(); }

void addClouds(Stage& stage) { stage.addClouds(); }

void addHaze(render::FrameFeatures& features) { features.haze = true; }

}  // namespace

const std::vector<Part>& parts() {
  static const std::vector<Part> all = {
      {Effect::aircraft, addAircraft, nullptr, {{"aircraft", "Aircraft", true}, {"autopilot", "Autopilot"}}},
      {Effect::targets, addTargets, nullptr, {{"game", "Game"}, {"package", "Package"}}},
      {Effect::clouds,
       addClouds,
       nullptr,
       {{"clouds", "Weather"}, {"clouds.march", "Exactness of the clouds"}}},
      {Effect::terrain,
       addLand,
       nullptr,
       {{"render.land", "Views of the land"},
        {"streaming", "Detail of the land"},
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
  for (const Part& part : parts()) {
    if (!effects.contains(part.effect)) continue;
    sections.insert(sections.end(), part.menuSections.begin(), part.menuSections.end());
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
  for (const Part& part : parts()) {
    if (part.addFeatures && effects.contains(part.effect)) part.addFeatures(features);
  }
  return features;
}

}  // namespace skydrop::app
