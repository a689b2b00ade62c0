// What the effect table says of lightning (EffectDescriptor).
#pragma once

#include "skydrop/render/frame/frame_features.h"

namespace skydrop::app {

class SceneRenderer;
class SettingsChange;

void addLightning(SceneRenderer& sceneRenderer);
void addLightningFeatures(render::FrameFeatures& features);
void applyLightning(SceneRenderer& sceneRenderer, const SettingsChange& change);

}  // namespace skydrop::app
