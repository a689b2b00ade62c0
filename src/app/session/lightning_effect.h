// What the effect table says of lightning (EffectDescriptor).
#pragma once

#include <optional>

#include "skydrop/render/frame/frame_features.h"
#include "skydrop/scene/effect.h"
#include "skydrop/weather/lightning_settings.h"

namespace skydrop::app {

class SceneRenderer;
class SettingsChange;
struct Settings;

void addLightning(SceneRenderer& sceneRenderer);
void addLightningFeatures(render::FrameFeatures& features);
void applyLightning(SceneRenderer& sceneRenderer, const SettingsChange& change);

// Whose thunder is heard (audio::SoundScene::setLightning); nullopt where there are no flashes.
std::optional<weather::LightningSettings> lightningOf(const scene::EffectSet& effects,
                                                      const Settings& settings);

}  // namespace skydrop::app
