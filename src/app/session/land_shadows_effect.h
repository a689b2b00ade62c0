// What the effect table says of the shadows of mountains (EffectDescriptor).
#pragma once

#include "skydrop/render/frame/frame_features.h"

namespace skydrop::app {

class SceneRenderer;
class SettingsChange;

void addLandShadows(SceneRenderer& sceneRenderer);
void addLandShadowFeatures(render::FrameFeatures& features);
void applyLandShadows(SceneRenderer& sceneRenderer, const SettingsChange& change);

}  // namespace skydrop::app
