// What the effect table says of cloud planes (EffectDescriptor).
#pragma once

#include <memory>

#include "app/session/preparation.h"

namespace skydrop::app {

class SceneRenderer;
class SettingsChange;
struct Settings;

// Noise that is not among the prepared resources (render::PreparedPlaneNoise) is made beside the first
// frames.
void addCloudPlanes(SceneRenderer& sceneRenderer);
void applyCloudPlanes(SceneRenderer& sceneRenderer, const SettingsChange& change);
// The noise of the layers that these settings draw.
std::unique_ptr<Preparation> prepareCloudPlanes(Preparation::Maker maker, const Settings& settings);

}  // namespace skydrop::app
