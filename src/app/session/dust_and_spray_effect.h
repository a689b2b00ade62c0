// What the effect table says of dust and spray (EffectDescriptor).
#pragma once

namespace skydrop::app {

class SceneRenderer;
class SettingsChange;

void addDustAndSpray(SceneRenderer& sceneRenderer);
void applyDustAndSpray(SceneRenderer& sceneRenderer, const SettingsChange& change);

}  // namespace skydrop::app
