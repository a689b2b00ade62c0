// What the effect table says of ground fog (EffectDescriptor).
#pragma once

namespace skydrop::app {

class SceneRenderer;
class SettingsChange;

void addGroundFog(SceneRenderer& sceneRenderer);
void applyGroundFog(SceneRenderer& sceneRenderer, const SettingsChange& change);

}  // namespace skydrop::app
