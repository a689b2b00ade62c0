#include "app/session/ground_detail_effect.h"

#include "app/session/made_preparation.h"
#include "app/session/scene_renderer.h"
#include "skydrop/render/terrain/ground_detail_pass.h"

namespace skydrop::app {

void addGroundDetail(SceneRenderer& sceneRenderer) {
  render::Renderer& renderer = sceneRenderer.renderer();
  const auto prepared = sceneRenderer.setup().prepared.find<terrain::GroundRelief>();
  renderer.add(std::make_unique<render::GroundDetailPass>(renderer.context(), prepared,
                                                          sceneRenderer.settings().groundDetail));
}

void applyGroundDetail(SceneRenderer& sceneRenderer, const SettingsChange& change) {
  if (!change.touches("groundDetail")) return;
  sceneRenderer.renderer().find<render::GroundDetailPass>()->apply(sceneRenderer.settings().groundDetail);
}

std::unique_ptr<Preparation> prepareGroundDetail(Preparation::Maker, const Settings& settings) {
  using Result = terrain::GroundRelief;
  return std::make_unique<MadePreparation<Result>>(
      "Making the ground",
      [texels = terrain::texelsOf(settings.groundDetail.texels)](
          const std::stop_token& stop, std::atomic<double>&) -> std::shared_ptr<const Result> {
        auto made = std::make_shared<const Result>(terrain::makeGroundRelief(texels, stop));
        return stop.stop_requested() ? nullptr : made;
      });
}

}  // namespace skydrop::app
