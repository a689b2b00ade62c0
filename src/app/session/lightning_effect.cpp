#include "app/session/lightning_effect.h"

#include "app/session/scene_renderer.h"
#include "skydrop/game/contact.h"
#include "skydrop/render/lightning/lightning_pass.h"

namespace skydrop::app {

void addLightning(SceneRenderer& sceneRenderer) {
  render::Renderer& renderer = sceneRenderer.renderer();
  const auto ground = [&sceneRenderer](const glm::dvec2& xz) {
    const auto& heights = sceneRenderer.setup().ground;
    return heights ? game::surfaceAt(*heights, xz).height : 0;
  };
  renderer.add(std::make_unique<render::LightningLightPass>(sceneRenderer.settings().lightning, ground));
  renderer.add(std::make_unique<render::LightningPass>(renderer.context()));
}

void addLightningFeatures(render::FrameFeatures& features) { features.flashLight = true; }

void applyLightning(SceneRenderer& sceneRenderer, const SettingsChange& change) {
  if (!change.touches("lightning")) return;
  sceneRenderer.renderer().find<render::LightningLightPass>()->apply(sceneRenderer.settings().lightning);
}

std::optional<weather::LightningSettings> lightningOf(const scene::EffectSet& effects,
                                                      const Settings& settings) {
  if (!scene::effective(effects).contains(scene::Effect::lightning)) return std::nullopt;
  return settings.lightning;
}

}  // namespace skydrop::app
