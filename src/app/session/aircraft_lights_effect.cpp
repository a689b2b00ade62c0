#include "app/session/aircraft_lights_effect.h"

#include "app/session/scene_renderer.h"
#include "skydrop/render/models/aircraft_lights_pass.h"
#include "skydrop/render/models/landing_light_pass.h"

namespace skydrop::app {

void addAircraftLights(SceneRenderer& sceneRenderer) {
  render::Renderer& renderer = sceneRenderer.renderer();
  renderer.add(std::make_unique<render::LampsPass>(sceneRenderer.settings().aircraftLights));
  renderer.add(std::make_unique<render::LampGlowPass>(renderer.context()));
}

void applyAircraftLights(SceneRenderer& sceneRenderer, const SettingsChange& change) {
  if (!change.touches("aircraftLights")) return;
  sceneRenderer.renderer().find<render::LampsPass>()->apply(sceneRenderer.settings().aircraftLights);
}

void addLandingLight(SceneRenderer& sceneRenderer) {
  render::Renderer& renderer = sceneRenderer.renderer();
  const render::LandingLightSettings& settings = sceneRenderer.settings().landingLight;
  renderer.add(std::make_unique<render::LandingLightPass>(settings));
  renderer.add(std::make_unique<render::LandingLightGlowPass>(renderer.context(), settings));
}

void addLandingLightFeatures(render::FrameFeatures& features) { features.spotLight = true; }

void applyLandingLight(SceneRenderer& sceneRenderer, const SettingsChange& change) {
  if (!change.touches("landingLight")) return;
  const render::LandingLightSettings& settings = sceneRenderer.settings().landingLight;
  sceneRenderer.renderer().find<render::LandingLightPass>()->apply(settings);
  sceneRenderer.renderer().find<render::LandingLightGlowPass>()->apply(settings);
}

}  // namespace skydrop::app
