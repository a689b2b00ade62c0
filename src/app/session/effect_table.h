// The one table that says what each effect needs. Nothing else decides what runs: what no effect of the scene
// names is not constructed. Which effects need others is the scene's business (scene::requiredEffects),
// because the simulation must know it too.
#pragma once

#include <memory>
#include <vector>

#include "app/session/preparation.h"
#include "skydrop/render/frame/frame_features.h"
#include "skydrop/scene/effect.h"
#include "skydrop/ui/menu.h"

namespace skydrop::app {

class SceneRenderer;
class SettingsChange;
struct Settings;

struct EffectDescriptor {
  scene::Effect effect;
  // Once, when a scene with the effect is built. Null: draws nothing of its own. May throw core::DataError
  // (shader, model).
  void (*addPasses)(SceneRenderer& sceneRenderer) = nullptr;
  // Null: shared shaders need not know.
  void (*addFeatures)(render::FrameFeatures& features) = nullptr;
  // While flying, before the next frame, whenever settings have changed: hands those that the change touches
  // to the passes. Null: its passes take no settings but FrameContext::settings.
  void (*apply)(SceneRenderer& sceneRenderer, const SettingsChange& change) = nullptr;
  // Starts what must be ready before addPasses, beside everything else, of the settings as they are now.
  // Null: nothing.
  std::unique_ptr<Preparation> (*prepare)(Preparation::Maker maker, const Settings& settings) = nullptr;
  // Settings that matter only with this effect.
  std::vector<ui::MenuSection> menuSections = {};
};

const std::vector<EffectDescriptor>& effectTable();

// Sections of the menu: those of the scene's effects in the order of the table, then those that every scene
// has.
std::vector<ui::MenuSection> menuSections(const scene::EffectSet& effects);

render::FrameFeatures frameFeatures(const scene::EffectSet& effects);

}  // namespace skydrop::app
