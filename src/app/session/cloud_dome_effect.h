// What the effect table says of the cloud dome (EffectDescriptor).
#pragma once

#include <memory>

#include "app/session/preparation.h"

namespace skydrop::app {

class SceneRenderer;
class SettingsChange;
struct Settings;

// Noise that is not among the prepared resources (render::PreparedDomeNoise) is made beside the first frames.
void addCloudDome(SceneRenderer& sceneRenderer);
void applyCloudDome(SceneRenderer& sceneRenderer, const SettingsChange& change);
// The volume of noise of these settings.
std::unique_ptr<Preparation> prepareCloudDome(Preparation::Maker maker, const Settings& settings);

}  // namespace skydrop::app
