#include "app/session/places_effect.h"

#include "app/session/scene_renderer.h"
#include "skydrop/render/places/places_pass.h"

namespace skydrop::app {
namespace {

std::shared_ptr<const terrain::Places> placesOf(const SceneRenderer& sceneRenderer) {
  return std::make_shared<const terrain::Places>(sceneRenderer.setup().ground,
                                                 sceneRenderer.settings().villages);
}

}  // namespace

void addPlaces(SceneRenderer& sceneRenderer) {
  render::Renderer& renderer = sceneRenderer.renderer();
  auto map = std::make_unique<render::PlaceMapPass>(renderer.context(), placesOf(sceneRenderer));
  const render::PlaceMapPass& of = *map;
  renderer.add(std::move(map));
  renderer.add(std::make_unique<render::PlacesPass>(renderer.context(), of, sceneRenderer.settings().places));
}

void applyPlaces(SceneRenderer& sceneRenderer, const SettingsChange& change) {
  render::Renderer& renderer = sceneRenderer.renderer();
  if (change.touches("villages")) renderer.find<render::PlaceMapPass>()->apply(placesOf(sceneRenderer));
  if (change.touches("places")) renderer.find<render::PlacesPass>()->apply(sceneRenderer.settings().places);
}

}  // namespace skydrop::app
