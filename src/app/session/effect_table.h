// The one table that says what each effect needs. Nothing else decides what runs: what no effect of the scene
// names is not constructed.
#pragma once

#include <vector>

#include "skydrop/render/frame/frame_features.h"
#include "skydrop/render/frame/renderer.h"
#include "skydrop/scene/effect.h"
#include "skydrop/ui/menu.h"

namespace skydrop::app {

class SceneRenderer;

struct EffectDescriptor {
  scene::Effect effect;
  void (*addPasses)(SceneRenderer& sceneRenderer);                      // null: draws nothing of its own
  void (*addFeatures)(render::FrameFeatures& features);  // null: shared shaders need not know
  std::vector<ui::MenuSection> menuSections;             // settings that matter only with this effect
};

const std::vector<EffectDescriptor>& effectTable();

// Sections of the menu: those of the scene's effects in the order of the table, then those that every scene has.
std::vector<ui::MenuSection> menuSections(const scene::EffectSet& effects);

render::FrameFeatures frameFeatures(const scene::EffectSet& effects);

}  // namespace skydrop::app
