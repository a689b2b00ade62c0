// What the effect table says of the ground's detail (EffectDescriptor).
#pragma once

#include <memory>

#include "app/session/preparation.h"

namespace skydrop::app {

class SceneRenderer;
class SettingsChange;
struct Settings;

// Squares that are not among the prepared resources (terrain::GroundRelief) are made at once.
void addGroundDetail(SceneRenderer& sceneRenderer);
void applyGroundDetail(SceneRenderer& sceneRenderer, const SettingsChange& change);
// The squares of these settings.
std::unique_ptr<Preparation> prepareGroundDetail(Preparation::Maker maker, const Settings& settings);

}  // namespace skydrop::app
