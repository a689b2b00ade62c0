// What the effect table says of clouds (EffectDescriptor).
#pragma once

#include <memory>

#include "app/session/preparation.h"

namespace skydrop::app {

class SceneRenderer;
class SettingsChange;
struct Settings;

// Throws core::DataError (shader). The noise (clouds::PackedCloudNoise) must be among the prepared resources.
void addClouds(SceneRenderer& sceneRenderer);
// Their shadows on the land; after addClouds().
void addCloudShadows(SceneRenderer& sceneRenderer);
void removeCloudShadows(SceneRenderer& sceneRenderer);
// Their shade on what flies; after addClouds().
void addCloudShade(SceneRenderer& sceneRenderer);
void applyClouds(SceneRenderer& sceneRenderer, const SettingsChange& change);
// The noise: from the player's cache, or made and put there.
std::unique_ptr<Preparation> prepareClouds(Preparation::Maker maker, const Settings& settings);

}  // namespace skydrop::app
