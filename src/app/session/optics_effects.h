// What the effect table says of halo and rainbow (EffectDescriptor).
#pragma once

namespace skydrop::app {

class SceneRenderer;
class SettingsChange;

void addHalo(SceneRenderer& sceneRenderer);
void applyHalo(SceneRenderer& sceneRenderer, const SettingsChange& change);
void addRainbow(SceneRenderer& sceneRenderer);
void applyRainbow(SceneRenderer& sceneRenderer, const SettingsChange& change);

}  // namespace skydrop::app
