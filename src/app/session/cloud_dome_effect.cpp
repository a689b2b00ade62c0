#include "app/session/cloud_dome_effect.h"

#include "app/session/made_preparation.h"
#include "app/session/scene_renderer.h"
#include "skydrop/render/clouds/cloud_dome.h"

namespace skydrop::app {

void addCloudDome(SceneRenderer& sceneRenderer) {
  render::Renderer& renderer = sceneRenderer.renderer();
  const auto prepared = sceneRenderer.setup().prepared.find<render::PreparedDomeNoise>();
  renderer.add(std::make_unique<render::CloudDome>(renderer.context(), prepared.get(),
                                                   sceneRenderer.settings().cloudDome));
}

void applyCloudDome(SceneRenderer& sceneRenderer, const SettingsChange& change) {
  if (!change.touches("cloudDome")) return;
  sceneRenderer.renderer().find<render::CloudDome>()->apply(sceneRenderer.settings().cloudDome);
}

std::unique_ptr<Preparation> prepareCloudDome(Preparation::Maker, const Settings& settings) {
  using Result = render::PreparedDomeNoise;
  return std::make_unique<MadePreparation<Result>>(
      "Making the cloud dome",
      [of = settings.cloudDome](std::stop_token stop,
                                std::atomic<double>& progress) -> std::shared_ptr<const Result> {
        auto made = std::make_shared<Result>();
        made->settings = of;
        made->volume = std::make_shared<const render::SheetNoise>(
            render::makeSheetNoise(of, stop, [&progress](double share) { progress = share; }));
        return stop.stop_requested() ? nullptr : made;
      });
}

}  // namespace skydrop::app
