// What the effect table says of what stands on the ground (EffectDescriptor).
#pragma once

namespace skydrop::app {

class SceneRenderer;
class SettingsChange;

void addGroundCover(SceneRenderer& sceneRenderer);
void applyGroundCover(SceneRenderer& sceneRenderer, const SettingsChange& change);

}  // namespace skydrop::app
