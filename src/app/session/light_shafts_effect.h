// What the effect table says of the shade in the air (EffectDescriptor).
#pragma once

namespace skydrop::app {

class SceneRenderer;
class SettingsChange;

void addLightShafts(SceneRenderer& sceneRenderer);
void applyLightShafts(SceneRenderer& sceneRenderer, const SettingsChange& change);

}  // namespace skydrop::app
