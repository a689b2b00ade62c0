#include <cmath>
#include <cstdio>
#include <glm/trigonometric.hpp>

#include "app/bindings.h"
#include "app/cloud_noise.h"
#include "app/frame_times.h"
#include "app/menu_desk.h"
#include "app/open_context.h"
#include "app/overlay.h"
#include "app/prepare.h"
#include "app/stage.h"
#include "app/statistics_json.h"
#include "app/stopwatch.h"
#include "app/verbs.h"
#include "skydrop/core/fixed_step.h"

namespace skydrop::app {
namespace {

constexpr Size kDefaultSize{1280, 720};

void place(render::Camera& camera, const Pose& pose) {
  camera.setMode(render::CameraMode::free);
  camera.setPose(pose.position, glm::radians(pose.yawDegrees), glm::radians(pose.pitchDegrees),
                 glm::radians(pose.rollDegrees));
}

// The step at which a frame is drawn: simulated time is a whole number of steps.
std::uint64_t stepOfFrame(const CommandLine& line, int frame) {
  const double seconds = line.timeS + frame / line.fps;
  return static_cast<std::uint64_t>(std::llround(seconds * core::FixedStep::kStepsPerSecond));
}

// Dear ImGui's windows find their size in the first frame that shows them.
void buildTwice(Overlay& overlay, const OverlayFrame& frame, Stage& stage) {
  for (int i = 0; i < 2; ++i) {
    if (overlay.build(frame).fontsChanged) stage.uploadFonts();
  }
}

}  // namespace

int render(const CommandLine& line) {
  const std::unique_ptr<Run> run = prepareRun(line);
  if (run->warning) std::fprintf(stderr, "skydrop: %s\n", run->warning->c_str());
  std::optional<CloudNoise> cloudNoise;  // got ready while the rest is
  if (scene::requiredEffects(run->setup.scene).contains(scene::Effect::clouds))
    cloudNoise.emplace(NoiseStore(cacheFolder()), CloudNoise::Maker::processor);
  const Size size = line.size.value_or(kDefaultSize);
  const auto context = openContext(line.backend, size);
  Simulation simulation(run->setup, run->settings, run->table);
  // While land is made this thread waits: its processor makes land too.
  const int workers = line.workers.value_or(core::JobPool::defaultWorkerCount() + 1);
  Stage stage(*context,
              {simulation.effects(), simulation.ground(), workers, line.stats.has_value(),
               cloudNoise ? cloudNoise->wait() : nullptr},
              run->settings);
  if (cloudNoise) {
    for (const std::string& message : cloudNoise->takeMessages())
      std::fprintf(stderr, "skydrop: %s\n", message.c_str());
  }
  if (line.pose) place(stage.camera(), *line.pose);
  std::unique_ptr<Overlay> overlay;
  if (simulation.effects().contains(scene::Effect::hud) || line.menu) {
    overlay = std::make_unique<Overlay>(simulation.effects(), size, helpRows(Bindings()),
                                        ui::InterfaceScale{run->settings.view.interfaceScale});
    overlay->menuOpen = line.menu;
    overlay->hudShown = run->settings.view.hud;
    stage.addOverlay();
  }

  MenuDesk desk(run->userFolder);
  if (overlay) {
    if (const auto warning = desk.load(overlay->menu()))
      std::fprintf(stderr, "skydrop: %s\n", warning->c_str());
  }

  FrameTimes times;
  core::FrameStatistics statistics, shown;  // the menu of a frame shows what those before it cost
  for (int frame = 0; frame < line.frames; ++frame) {
    while (simulation.world().stepCount() < stepOfFrame(line, frame)) {
      simulation.step({});
      simulation.world().takeEvents();
    }
    const game::Snapshot& now = simulation.world().now();
    if (overlay) {
      OverlayFrame content{now, size, 0, run->table};
      content.scale = {run->settings.view.interfaceScale};
      content.statistics = &shown;
      content.tools = desk.tools(run->baseTable, stage.view(now, size), times.newest(times.count()));
      buildTwice(*overlay, content, stage);
    }
    stage.renderer().finish();
    const Stopwatch drawing;
    stage.draw(now, size, Streaming::settled);
    stage.renderer().finish();
    times.add(drawing.ms() - stage.settleMs());
    statistics.other["settle"] += stage.settleMs();

    const Stopwatch reading;
    const core::Image image = stage.renderer().readBack();
    statistics.other["readBack"] += reading.ms();
    const Stopwatch writing;
    core::writePng(framePath(line.out, frame), image);
    statistics.other["png"] += writing.ms();
    if (overlay && overlay->showsCosts()) {
      shown = {};
      simulation.writeTo(shown);
      stage.writeTo(shown);
    }
    std::printf("%s\n", framePath(line.out, frame).c_str());
  }
  for (const std::string& message : stage.takeMessages())
    std::fprintf(stderr, "skydrop: %s\n", message.c_str());

  if (line.stats) {
    times.writeTo(statistics);
    simulation.writeTo(statistics);
    stage.writeTo(statistics);
    writeStatistics(*line.stats, statistics);
  }
  return 0;
}

}  // namespace skydrop::app
