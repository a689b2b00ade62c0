#include "app/session/cloud_planes_effect.h"

#include "app/session/made_preparation.h"
#include "app/session/scene_renderer.h"
#include "skydrop/render/clouds/cloud_plane.h"

namespace skydrop::app {

void addCloudPlanes(SceneRenderer& sceneRenderer) {
  render::Renderer& renderer = sceneRenderer.renderer();
  const auto prepared = sceneRenderer.setup().prepared.find<render::PreparedPlaneNoise>();
  const Settings& settings = sceneRenderer.settings();
  renderer.add(std::make_unique<render::CloudPlanes>(renderer.context(), prepared.get(), settings.cloudPlanes,
                                                     settings.wind));
}

void applyCloudPlanes(SceneRenderer& sceneRenderer, const SettingsChange& change) {
  if (!change.touches("cloudPlanes") && !change.touches("wind")) return;
  const Settings& settings = sceneRenderer.settings();
  sceneRenderer.renderer().find<render::CloudPlanes>()->apply(settings.cloudPlanes, settings.wind);
}

std::unique_ptr<Preparation> prepareCloudPlanes(Preparation::Maker, const Settings& settings) {
  using Result = render::PreparedPlaneNoise;
  return std::make_unique<MadePreparation<Result>>(
      "Making the cloud planes",
      [of = settings.cloudPlanes](std::stop_token stop,
                                  std::atomic<double>& progress) -> std::shared_ptr<const Result> {
        auto made = std::make_shared<Result>();
        made->settings = of.layers;
        const auto count = static_cast<std::size_t>(of.count);
        for (std::size_t i = 0; i < count; ++i) {
          made->layers[i] =
              std::make_shared<const render::SheetNoise>(render::makeSheetNoise(of.layers[i], stop));
          if (stop.stop_requested()) return nullptr;
          progress = static_cast<double>(i + 1) / static_cast<double>(count);
        }
        return made;
      });
}

}  // namespace skydrop::app
