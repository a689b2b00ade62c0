// What the effect table says of vegetation (EffectDescriptor).
#pragma once

namespace skydrop::app {

class SceneRenderer;
class SettingsChange;

void addVegetation(SceneRenderer& sceneRenderer);
void applyVegetation(SceneRenderer& sceneRenderer, const SettingsChange& change);

}  // namespace skydrop::app
