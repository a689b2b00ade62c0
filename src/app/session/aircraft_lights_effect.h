// What the effect table says of the aircraft's lights and its landing light (EffectDescriptor).
#pragma once

namespace skydrop::render {
struct FrameFeatures;
}

namespace skydrop::app {

class SceneRenderer;
class SettingsChange;

void addAircraftLights(SceneRenderer& sceneRenderer);
void applyAircraftLights(SceneRenderer& sceneRenderer, const SettingsChange& change);

void addLandingLight(SceneRenderer& sceneRenderer);
void addLandingLightFeatures(render::FrameFeatures& features);
void applyLandingLight(SceneRenderer& sceneRenderer, const SettingsChange& change);

}  // namespace skydrop::app
