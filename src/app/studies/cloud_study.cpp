#include "app/studies/cloud_study.h"

#include <glm/trigonometric.hpp>

#include "app/measure/system_info.h"
#include "app/session/cloud_noise.h"
#include "app/session/open_context.h"
#include "app/session/run_config.h"
#include "app/settings/cloud_tier.h"
#include "app/studies/timed_frame.h"

namespace skydrop::app {
namespace {

using clouds::CloudTier;

constexpr Size kSize{320, 180};  // a frame of the reference takes seconds
constexpr int kTimedFrames = 7;

}  // namespace

StudyResult cloudStudy(const StudyProgress& progress) {
  CommandLine line;
  line.verb = Verb::accuracy;
  line.scene.emplace("fair");
  const CloudNoise noise(NoiseStore(cacheFolder()), CloudNoise::Maker::processor);
  const auto run = prepareRun(line);
  const CloudTier shipped = run->settings.clouds.tier;
  const auto context = openContext(std::nullopt, kSize);
  Simulation simulation(run->setup, run->settings, run->table);
  SceneRenderer sceneRenderer(
      *context,
      {simulation.effects(), simulation.ground(), std::nullopt, false, PreparedResources(noise.wait())},
      run->settings);
  sceneRenderer.camera().setMode(render::CameraMode::free);
  sceneRenderer.camera().setPose({0, 600, 0}, glm::radians(40.0), glm::radians(12.0), 0);
  const game::Snapshot& snapshot = simulation.world().now();

  const auto frameOf = [&](CloudTier tier, int times) {
    run->settings.clouds.tier = tier;
    applyCloudTier(run->table, readCloudTier(cloudTierPath(tier)));
    sceneRenderer.apply(SettingsChange::ofAll(run->table));
    return drawTimed(sceneRenderer, snapshot, kSize, times);
  };
  StudyResult result;
  result.title = "Clouds";
  result.method =
      "Cumulus from below: the scene `fair` at 320 x 180 from `--pose=0,600,0,40,12,0`, by `clouds.tier`, "
      "against the tier reference. What a tier says stands in `assets/clouds`; any of its rows can be set by "
      "itself.";
  result.metrics = {{"error of the picture", "root mean square of 8-bit steps"}};
  result.cost = {"ms a frame", clockOfTimedFrames(kTimedFrames) + " (reference: one)"};
  result.machine = machineName() + ", " + context->renderer();
  constexpr CloudTier kTiers[] = {CloudTier::off, CloudTier::low, CloudTier::medium, CloudTier::high,
                                  CloudTier::ultra};
  progress(0, std::size(kTiers) + 1);
  const TimedFrame reference = frameOf(CloudTier::reference, 1);
  for (const CloudTier tier : kTiers) {
    progress(result.rows.size() + 1, std::size(kTiers) + 1);
    const TimedFrame frame = frameOf(tier, kTimedFrames);
    result.rows.push_back({std::string(clouds::kCloudTierNames[static_cast<std::size_t>(tier)]),
                           {rootMeanSquare(frame.image, reference.image)},
                           frame.ms,
                           tier == shipped ? "default" : ""});
  }
  result.rows.push_back({"reference", {0}, reference.ms, ""});
  return result;
}

}  // namespace skydrop::app
