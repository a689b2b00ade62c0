// What the effect table says of precipitation (EffectDescriptor).
#pragma once

namespace skydrop::render {
struct FrameFeatures;
}

namespace skydrop::app {

class SceneRenderer;
class SettingsChange;

void addPrecipitation(SceneRenderer& sceneRenderer);
void addPrecipitationFeatures(render::FrameFeatures& features);
void applyPrecipitation(SceneRenderer& sceneRenderer, const SettingsChange& change);
// With clouds: rain below those that are drawn.
void addRainMap(SceneRenderer& sceneRenderer);
// With land: what lies on it, and splashes on the sea.
void addFallenWater(SceneRenderer& sceneRenderer);

}  // namespace skydrop::app
