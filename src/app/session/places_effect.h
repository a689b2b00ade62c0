// What the effect table says of places (EffectDescriptor).
#pragma once

namespace skydrop::app {

class SceneRenderer;
class SettingsChange;

void addPlaces(SceneRenderer& sceneRenderer);
void applyPlaces(SceneRenderer& sceneRenderer, const SettingsChange& change);

}  // namespace skydrop::app
