#include "app/session/effect_table.h"

#include "app/session/aircraft_lights_effect.h"
#include "app/session/cloud_dome_effect.h"
#include "app/session/cloud_effect.h"
#include "app/session/cloud_planes_effect.h"
#include "app/session/dust_and_spray_effect.h"
#include "app/session/ground_cover_effect.h"
#include "app/session/ground_detail_effect.h"
#include "app/session/ground_fog_effect.h"
#include "app/session/ice_clouds_effect.h"
#include "app/session/land_shadows_effect.h"
#include "app/session/light_shafts_effect.h"
#include "app/session/lightning_effect.h"
#include "app/session/model_reading.h"
#include "app/session/night_sky_effects.h"
#include "app/session/optics_effects.h"
#include "app/session/places_effect.h"
#include "app/session/precipitation_effect.h"
#include "app/session/scene_renderer.h"
#include "app/session/vegetation_effect.h"
#include "app/session/water_detail_effect.h"
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
      renderer.context(), readModel(core::assetPath("models/airplane.glb")), "airplane");
  renderer.add(std::make_unique<render::AircraftPass>(model));
  renderer.add(std::make_unique<render::PropellerPass>(model));
}

void castAircraftShadow(SceneRenderer& sceneRenderer) {
  const auto* pass = sceneRenderer.renderer().find<render::AircraftPass>();
  sceneRenderer.castShadow(render::aircraftShadow(pass->model()));
}

void addTargets(SceneRenderer& sceneRenderer) {
  render::Renderer& renderer = sceneRenderer.renderer();
  const auto models = std::make_shared<const render::PackageModels>(renderer.context(), readModel);
  renderer.add(std::make_unique<render::PackagePass>(models));
  renderer.add(std::make_unique<render::MarkerPass>(renderer.context()));
}

void castPackageShadows(SceneRenderer& sceneRenderer) {
  const auto* pass = sceneRenderer.renderer().find<render::PackagePass>();
  sceneRenderer.castShadow(render::packageShadows(pass->models()));
}

void addLand(SceneRenderer& sceneRenderer) {
  const SceneRenderer::Setup& setup = sceneRenderer.setup();
  const int workers = setup.workers.value_or(core::JobPool::defaultWorkerCount());
  sceneRenderer.stream(std::make_unique<LandStreaming>(sceneRenderer.renderer(), setup.ground, workers,
                                                       sceneRenderer.settings().streaming));
  if (setup.images.empty()) return;
  const elevation::ElevationSettings& place = sceneRenderer.settings().elevation;
  sceneRenderer.streaming()->wear(setup.images, {place.latitude, place.longitude},
                                  sceneRenderer.settings().aerialImage);
}

void removeLand(SceneRenderer& sceneRenderer) { sceneRenderer.stream(nullptr); }

void applyLand(SceneRenderer& sceneRenderer, const SettingsChange& change) {
  if (change.touches("streaming")) sceneRenderer.streaming()->apply(sceneRenderer.settings().streaming);
  if (change.touches("aerialImage")) sceneRenderer.streaming()->apply(sceneRenderer.settings().aerialImage);
}

void addHaze(render::FrameFeatures& features) { features.haze = true; }
void addOvercast(render::FrameFeatures& features) { features.overcast = true; }

}  // namespace

const std::vector<EffectDescriptor>& effectTable() {
  static const std::vector<EffectDescriptor> all = {
      {.effect = Effect::aircraft,
       .addPasses = addAircraft,
       .joints = {{Effect::terrain, castAircraftShadow}},
       .menuSections = {{"aircraft", "Aircraft", true},
                        {"assist", "Assistance"},
                        {"autopilot", "Autopilot"}}},
      {.effect = Effect::targets,
       .addPasses = addTargets,
       .joints = {{Effect::terrain, castPackageShadows}},
       .menuSections = {{"game", "Game"}, {"package", "Package"}, {"delivery", "Deliveries"}}},
      // Before clouds, which lie before what water mirrors.
      {.effect = Effect::waterDetail,
       .addPasses = addWaterDetail,
       .apply = applyWaterDetail,
       .menuSections = {{"waterDetail", "Water close by", false, {"wind"}}}},
      {.effect = Effect::clouds,
       .addPasses = addClouds,
       .joints = {{Effect::terrain, addCloudShadows, removeCloudShadows}, {Effect::aircraft, addCloudShade}},
       .apply = applyClouds,
       .prepare = prepareClouds,
       .menuSections = {{"clouds", "Low clouds", false, {"wind"}}, {"clouds.march", "Cloud quality"}}},
      {.effect = Effect::cloudDome,
       .addPasses = addCloudDome,
       .apply = applyCloudDome,
       .prepare = prepareCloudDome,
       .menuSections = {{"cloudDome", "Cloud dome"}}},
      // Before cloud planes, which lie below them.
      {.effect = Effect::iceClouds,
       .addPasses = addIceClouds,
       .joints = {{Effect::terrain, addIceShade}, {Effect::halo, addIceHalo, removeIceHalo}},
       .apply = applyIceClouds,
       .menuSections = {{"iceClouds", "Ice clouds", false, {"wind"}}}},
      {.effect = Effect::cloudPlanes,
       .addPasses = addCloudPlanes,
       .apply = applyCloudPlanes,
       .prepare = prepareCloudPlanes,
       .menuSections = {{"cloudPlanes", "Cloud planes", false, {"wind"}}}},
      // Before air and fog, which lie over what it lights.
      {.effect = Effect::lightning,
       .addPasses = addLightning,
       .addFeatures = addLightningFeatures,
       .apply = applyLightning,
       .menuSections = {{"lightning", "Lightning"}}},
      // After clouds, before air and fog, which lie over it.
      {.effect = Effect::dustAndSpray,
       .addPasses = addDustAndSpray,
       .apply = applyDustAndSpray,
       .menuSections = {{"dustAndSpray", "Dust and spray"}}},
      // Before fog, which lies over what the air sends.
      {.effect = Effect::lightShafts,
       .addPasses = addLightShafts,
       .apply = applyLightShafts,
       .menuSections = {{"lightShafts", "Light shafts"}}},
      {.effect = Effect::groundFog,
       .addPasses = addGroundFog,
       .apply = applyGroundFog,
       .menuSections = {{"groundFog", "Ground fog"}}},
      // After clouds: what lights models is theirs before it is the mountains' (LandShadowPass).
      {.effect = Effect::landShadows,
       .addPasses = addLandShadows,
       .addFeatures = addLandShadowFeatures,
       .apply = applyLandShadows,
       .menuSections = {{"landShadows", "Mountain shadows"}}},
      {.effect = Effect::terrain,
       .addPasses = addLand,
       .remove = removeLand,
       .apply = applyLand,
       .menuSections = {{"render.land", "Views of the land"},
                        {"streaming", "Terrain LOD"},
                        {"terrain", "Shape of the land"},
                        {"strips", "Grass strips"},
                        {"elevation", "Elevation data"},
                        {"aerialImage", "Aerial image"}}},
      {.effect = Effect::sky,
       .addPasses = addSky,
       .menuSections = {{"sky", "Sky", false, {"render.sky"}, ui::MenuSection::Head::choiceButtons},
                        {"render.sun", "Sun and clock", false, {}, ui::MenuSection::Head::clock}}},
      {.effect = Effect::moon, .addPasses = addMoon, .apply = applyMoon},
      {.effect = Effect::stars,
       .addPasses = addStars,
       .apply = applyStars,
       .menuSections = {{"stars", "Stars"}}},
      {.effect = Effect::halo, .addPasses = addHalo, .apply = applyHalo, .menuSections = {{"halo", "Halo"}}},
      {.effect = Effect::rainbow,
       .addPasses = addRainbow,
       .apply = applyRainbow,
       .menuSections = {{"rainbow", "Rainbow"}}},
      {.effect = Effect::haze, .addFeatures = addHaze, .menuSections = {{"render.atmosphere", "Air"}}},
      {.effect = Effect::weather,
       .addFeatures = addOvercast,
       .menuSections = {{"weather", "Weather", false, {}, ui::MenuSection::Head::weather},
                        {"weatherFile", "Hour of a weather file"},
                        {"live", "Live weather"}}},
      {.effect = Effect::aircraftLights,
       .addPasses = addAircraftLights,
       .apply = applyAircraftLights,
       .menuSections = {{"aircraftLights", "Aircraft lights"}}},
      {.effect = Effect::landingLight,
       .addPasses = addLandingLight,
       .addFeatures = addLandingLightFeatures,
       .apply = applyLandingLight,
       .menuSections = {{"landingLight", "Landing light"}}},
      {.effect = Effect::precipitation,
       .addPasses = addPrecipitation,
       .joints = {{Effect::clouds, addRainMap}, {Effect::terrain, addFallenWater}},
       .addFeatures = addPrecipitationFeatures,
       .apply = applyPrecipitation,
       .menuSections = {{"precipitation", "Rain and snow"}}},
      // After the land: they stand on it.
      {.effect = Effect::vegetation,
       .addPasses = addVegetation,
       .apply = applyVegetation,
       .menuSections = {{"vegetation", "Trees"}, {"woods", "Woods"}}},
      // After the land, as trees.
      {.effect = Effect::places,
       .addPasses = addPlaces,
       .apply = applyPlaces,
       .menuSections = {{"places", "Villages"}, {"villages", "Places of the land"}}},
      {.effect = Effect::groundCover,
       .addPasses = addGroundCover,
       .apply = applyGroundCover,
       .menuSections = {{"groundCover", "Grass and stones"}}},
      {.effect = Effect::groundDetail,
       .addPasses = addGroundDetail,
       .apply = applyGroundDetail,
       .prepare = prepareGroundDetail,
       .menuSections = {{"groundDetail", "Ground detail"}}},
      {.effect = Effect::groundHandling, .menuSections = {{"gear", "Landing gear"}}},
      {.effect = Effect::sound, .menuSections = {{"audio", "Sound"}}},
      {.effect = Effect::hud},
  };
  return all;
}

std::vector<ui::MenuSection> menuSections(const scene::EffectSet& effects) {
  std::vector<ui::MenuSection> sections = {{"effects", "Effects"}};
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

render::FrameFeatures frameFeatures(const scene::EffectSet& effects,
                                    const std::vector<EffectDescriptor>& table) {
  render::FrameFeatures features;
  for (const EffectDescriptor& row : table) {
    if (row.addFeatures && effects.contains(row.effect)) row.addFeatures(features);
  }
  return features;
}

}  // namespace skydrop::app
