// What the effect table says of moon and stars (EffectDescriptor).
#pragma once

namespace skydrop::app {

class SceneRenderer;
class SettingsChange;

void addMoon(SceneRenderer& sceneRenderer);
void applyMoon(SceneRenderer& sceneRenderer, const SettingsChange& change);
void addStars(SceneRenderer& sceneRenderer);
void applyStars(SceneRenderer& sceneRenderer, const SettingsChange& change);

}  // namespace skydrop::app
