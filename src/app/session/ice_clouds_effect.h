// The row of the effect table for high clouds of ice.
#pragma once

#include "app/settings/settings_change.h"

namespace skydrop::app {

class SceneRenderer;

void addIceClouds(SceneRenderer& sceneRenderer);
// With land: what the layers leave of the light on it, on models and on lower clouds.
void addIceShade(SceneRenderer& sceneRenderer);
// With halos: the layers scatter what the halo's tables say, in place of ice by hand.
void addIceHalo(SceneRenderer& sceneRenderer);
void removeIceHalo(SceneRenderer& sceneRenderer);
void applyIceClouds(SceneRenderer& sceneRenderer, const SettingsChange& change);

}  // namespace skydrop::app
