#include "app/session/night_sky_effects.h"

#include "app/session/scene_renderer.h"
#include "skydrop/core/assets.h"
#include "skydrop/render/sky/moon_pass.h"
#include "skydrop/render/sky/stars_pass.h"

namespace skydrop::app {

void addMoon(SceneRenderer& sceneRenderer) {
  render::Renderer& renderer = sceneRenderer.renderer();
  renderer.add(std::make_unique<render::MoonPass>(renderer.context(), sceneRenderer.settings().render.sun));
}

void applyMoon(SceneRenderer& sceneRenderer, const SettingsChange& change) {
  if (!change.touches("render.sun")) return;
  sceneRenderer.renderer().find<render::MoonPass>()->apply(sceneRenderer.settings().render.sun);
}

void addStars(SceneRenderer& sceneRenderer) {
  render::Renderer& renderer = sceneRenderer.renderer();
  renderer.add(std::make_unique<render::StarsPass>(renderer.context(),
                                                   sky::readStars(core::assetPath("stars/stars.bin")),
                                                   sceneRenderer.settings().stars));
}

void applyStars(SceneRenderer& sceneRenderer, const SettingsChange& change) {
  if (!change.touches("stars")) return;
  sceneRenderer.renderer().find<render::StarsPass>()->apply(sceneRenderer.settings().stars);
}

}  // namespace skydrop::app
