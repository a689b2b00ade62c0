// The one table that says what each effect needs. Nothing else decides what runs: what no effect of the scene
// names is not constructed. Which effects need others is the scene's business (scene::requiredEffects),
// because the simulation must know it too.
//
// A row holds all of an effect on purpose, the titles of its menu sections beside its passes: one who adds an
// effect reads and writes one place, and what no row names exists nowhere.
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
  // When the effect comes, at the start or while flying. Null: draws nothing of its own. May throw
  // core::DataError (shader, model). What is added to the renderer goes with the effect.
  void (*addPasses)(SceneRenderer& sceneRenderer) = nullptr;
  // Passes that are there only while another effect is too, such as shadows on land; added after those of
  // both.
  struct Joint {
    scene::Effect with;
    void (*addPasses)(SceneRenderer& sceneRenderer);
    void (*remove)(SceneRenderer& sceneRenderer) = nullptr;  // as that of the effect
  };
  std::vector<Joint> joints = {};
  // When the effect goes, before its passes do: gives up what else addPasses made. Null: nothing.
  void (*remove)(SceneRenderer& sceneRenderer) = nullptr;
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

render::FrameFeatures frameFeatures(const scene::EffectSet& effects,
                                    const std::vector<EffectDescriptor>& table = effectTable());

}  // namespace skydrop::app
