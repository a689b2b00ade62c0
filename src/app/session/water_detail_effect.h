// What the effect table says of water close by (EffectDescriptor).
#pragma once

namespace skydrop::app {

class SceneRenderer;
class SettingsChange;

void addWaterDetail(SceneRenderer& sceneRenderer);
void applyWaterDetail(SceneRenderer& sceneRenderer, const SettingsChange& change);

}  // namespace skydrop::app
