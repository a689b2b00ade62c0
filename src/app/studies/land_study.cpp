#include "app/studies/land_study.h"

#include <algorithm>
#include <vector>

#include "app/measure/system_info.h"
#include "app/session/open_context.h"
#include "app/session/run_config.h"
#include "app/studies/timed_frame.h"

namespace skydrop::app {
namespace {

constexpr Size kSize{640, 360};
constexpr double kReferenceError = 0.1;  // px; the finest that the setting allows
constexpr int kTimedFrames = 7;

}  // namespace

StudyResult landStudy(const StudyProgress& progress) {
  CommandLine line;
  line.verb = Verb::accuracy;
  line.scene.emplace("terrain");
  const auto run = prepareRun(line);
  const double shipped = run->settings.streaming.pixelError;
  const auto context = openContext(std::nullopt, kSize);
  Simulation simulation(run->setup, run->settings, run->table);
  SceneRenderer sceneRenderer(*context, {simulation.effects(), simulation.ground(), std::nullopt, false},
                              run->settings);
  const game::Snapshot& snapshot = simulation.world().now();

  const auto frameAt = [&](double pixelError) {
    run->settings.streaming.pixelError = pixelError;
    sceneRenderer.apply(SettingsChange::ofAll(run->table));
    return drawTimed(sceneRenderer, snapshot, kSize, kTimedFrames);
  };
  StudyResult result;
  result.title = "Terrain LOD";
  result.method =
      "The first view of the scene `terrain` at 640 x 360, by `streaming.pixelError` (the vertical error "
      "that the mesh may show, in pixels), against " +
      std::to_string(kReferenceError).substr(0, 3) + " px.";
  result.metrics = {{"error of the picture", "root mean square of 8-bit steps"}};
  result.cost = {"ms a frame", clockOfTimedFrames(kTimedFrames)};
  result.machine = machineName() + ", " + context->renderer();
  std::vector<double> errors = {0.5, 1, 2, 4, 8, 16, shipped};
  std::sort(errors.begin(), errors.end());
  errors.erase(std::unique(errors.begin(), errors.end()), errors.end());
  progress(0, errors.size() + 1);
  const TimedFrame reference = frameAt(kReferenceError);
  for (const double pixelError : errors) {
    progress(result.rows.size() + 1, errors.size() + 1);
    const TimedFrame frame = frameAt(pixelError);
    char label[32];
    std::snprintf(label, sizeof label, "%g px", pixelError);
    result.rows.push_back({label,
                           {rootMeanSquare(frame.image, reference.image)},
                           frame.ms,
                           pixelError == shipped ? "default" : ""});
  }
  result.rows.push_back({"reference", {0}, reference.ms, ""});
  return result;
}

}  // namespace skydrop::app
