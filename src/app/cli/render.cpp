#include <cmath>
#include <cstdio>
#include <map>
#include <span>
#include <string>

#include "app/cli/frame_path.h"
#include "app/cli/photo_comparison.h"
#include "app/cli/photo_sky.h"
#include "app/cli/verbs.h"
#include "app/console/message.h"
#include "app/console/progress.h"
#include "app/console/standard_output.h"
#include "app/input/bindings.h"
#include "app/measure/frame_times.h"
#include "app/measure/statistics_json.h"
#include "app/measure/stopwatch.h"
#include "app/session/end_flight.h"
#include "app/session/open_context.h"
#include "app/session/picture_texts.h"
#include "app/session/preparations.h"
#include "app/session/run_config.h"
#include "app/session/scene_renderer.h"
#include "app/session/split_view.h"
#include "app/session/start_camera.h"
#include "app/window/menu_controller.h"
#include "app/window/overlay.h"
#include "app/window/split_texts.h"
#include "app/window/weather_bar_data.h"
#include "skydrop/core/error.h"
#include "skydrop/core/fixed_step.h"
#include "skydrop/render/terrain/terrain_pass.h"
#include "skydrop/sky/instant.h"

namespace skydrop::app {
namespace {

constexpr Size kDefaultSize{1280, 720};
constexpr const char* kCoarserLand =
    "--split: the land's reference is coarser than it should be: streaming.cacheMiB or streaming.gpuMiB is "
    "full";

// The step at which a frame is drawn: simulated time is a whole number of steps.
std::uint64_t stepOfFrame(const CommandLine& line, int frame) {
  const double seconds = line.timeS + frame / line.fps;
  return static_cast<std::uint64_t>(std::llround(seconds * core::FixedStep::kStepsPerSecond));
}

// Dear ImGui's windows find their size in the first frame that shows them.
void buildTwice(Overlay& overlay, const OverlayFrame& frame, SceneRenderer& sceneRenderer) {
  for (int i = 0; i < 2; ++i) {
    if (overlay.build(frame).fontsChanged) sceneRenderer.uploadFonts();
  }
}

// The file of every frame, opened or refused before the first is drawn. What is written to in order (a pipe)
// stays open.
class FrameFiles {
 public:
  explicit FrameFiles(const CommandLine& line) : pattern_(line.out) {
    if (pattern_ == "-") streams_.emplace(line.firstFrame, openOutput(pattern_).value());
    for (int frame = line.firstFrame; pattern_ != "-" && frame < line.frames; ++frame) {
      core::OutputFile file(path(frame));
      if (file.isStream()) streams_.emplace(frame, std::move(file));
    }
  }

  void write(int frame, const core::Image& image, std::span<const core::PictureText> texts) {
    const auto stream = streams_.find(frame);
    if (stream == streams_.end()) return core::writePng(path(frame), image, texts);
    stream->second.write(core::encodePng(image, texts));
  }
  std::string path(int frame) const { return framePath(pattern_, frame); }

 private:
  std::string pattern_;
  std::map<int, core::OutputFile> streams_;
};

// "12 of 600 s, frame 1 of 3"
std::string progressState(const CommandLine& line, int frame, std::uint64_t step) {
  constexpr std::uint64_t kRate = core::FixedStep::kStepsPerSecond;
  std::string state = std::to_string(step / kRate) + " of " +
                      std::to_string(stepOfFrame(line, line.frames - 1) / kRate) + " s";
  if (line.frames > 1) state += ", frame " + std::to_string(frame + 1) + " of " + std::to_string(line.frames);
  return state;
}

// What --split asks for, judged before anything is drawn.
std::optional<SplitReference> splitOf(const CommandLine& line, const RunConfig& run) {
  if (!line.split) return std::nullopt;
  try {
    return splitReference(run.settings, effectsOf(run), *line.split);
  } catch (const core::RangeError& refusal) {
    throw core::UsageError(std::string("--split: ") + refusal.what());
  }
}

// Effects that no pass draws.
void noteIdle(core::FrameStatistics& statistics, const Overlay* overlay) {
  if (core::EffectStatistics* bill = statistics.billOf(scene::nameOf(scene::Effect::sound)))
    bill->idle = "there is no window";
  if (core::EffectStatistics* bill = statistics.billOf(scene::nameOf(scene::Effect::hud)))
    bill->idle = overlay && overlay->hudShown ? "" : "switched off (view.hud)";
}

}  // namespace

namespace {

// The photograph beside a frame that has just been drawn.
std::string compared(PhotoComparison& photo, SceneRenderer& sceneRenderer, const core::Image& image,
                     const render::View& view, int frame, double seconds, const Settings& settings) {
  const render::SunSettings& sun = settings.render.sun;
  std::optional<sky::Instant> utc;
  if (sun.source == render::SunSource::clock) {
    const double later =
        sun.shiftDays * 86400 + sun.shiftHours * 3600 + sun.offsetSeconds + seconds * sun.timeScale;
    utc = sky::Instant{sun.utcMs + std::llround(1000 * later)};
  }
  if (!photo.wantsSky()) return photo.compare(image, view, frame, seconds, utc);
  std::vector<float> depths;
  if (const auto* land = sceneRenderer.renderer().find<render::TerrainPass>()) {
    const render::gl::Texture& depth = land->landDepth();
    depths.resize(static_cast<std::size_t>(depth.width()) * static_cast<std::size_t>(depth.height()));
    depth.read(GL_DEPTH_COMPONENT, GL_FLOAT, std::as_writable_bytes(std::span(depths)));
    if (depth.width() != view.width || depth.height() != view.height)
      throw core::UsageError("--photo-mask frame: needs render.scale=1");
  }
  const core::Image sky = skyOfFrame(view, depths);
  return photo.compare(image, view, frame, seconds, utc, &sky);
}

}  // namespace

int render(const CommandLine& line) {
  const std::unique_ptr<RunConfig> run = prepareRun(line);
  if (sets(line, "view.frameBudgetMs") && run->settings.view.frameBudgetMs > 0)
    throw core::UsageError(std::string("--set: view.frameBudgetMs: ") + kNoBudgetHere);
  const std::optional<SplitReference> reference = splitOf(line, *run);
  std::optional<PhotoComparison> photo;
  if (line.photo) photo.emplace(*line.photo);
  FrameFiles files(line);
  std::optional<core::OutputFile> stats = openOutput(line.stats);
  if (run->warning) warn(*run->warning);
  for (const std::string& note : run->notes) warn(note);
  Preparations preparations;  // beside the rest
  preparations.begin(effectsOf(*run), Preparation::Maker::processor, run->settings);
  const Size size = line.size.value_or(kDefaultSize);
  const auto context = openContext(line.backend, size);
  Simulation simulation(run->setup, run->settings, run->table);
  // While land is made this thread waits: its processor makes land too.
  const int workers = line.workers.value_or(core::JobPool::defaultWorkerCount() + 1);
  preparations.waitUntilReady();
  const scene::EffectSet& effects = simulation.effects();
  SceneRenderer sceneRenderer(*context,
                              {.effects = effects,
                               .ground = simulation.ground(),
                               .workers = workers,
                               .measuring = stats.has_value(),
                               .prepared = preparations.results(effects),
                               .images = simulation.images()},
                              run->settings);
  simulation.setMeasuring(stats.has_value());
  for (const std::string& message : preparations.takeMessages()) warn(message);
  if (line.pose) {
    placeCamera(sceneRenderer.camera(), *line.pose, *simulation.ground());
    if (const auto warning = underSurface(sceneRenderer.camera(), *simulation.ground());
        warning && sceneRenderer.land())
      warn(*warning);
  }
  const bool showsBar = run->settings.view.weatherBar && run->setup.forecast;
  WeatherBarData weatherBarData;
  core::GuardWatch guards;
  std::unique_ptr<Overlay> overlay;
  if (simulation.effects().contains(scene::Effect::hud) || line.menu || reference || showsBar) {
    overlay = std::make_unique<Overlay>(simulation.effects(), size, helpRows(Bindings()),
                                        ui::InterfaceScale{run->settings.view.interfaceScale});
    overlay->menuOpen = line.menu;
    overlay->setMeasuring(stats.has_value());
    // A camera in the world sees another place than the aircraft that the HUD is about.
    overlay->hudShown = run->settings.view.hud && (!line.pose || sets(line, "view.hud"));
    sceneRenderer.addOverlay();
  }

  MenuController menuController(run->userFolder);
  if (overlay) {
    if (const auto warning = menuController.load(overlay->menu())) warn(*warning);
  }

  std::unique_ptr<SplitView> split;
  if (reference) split = std::make_unique<SplitView>(sceneRenderer, run->settings, *reference);

  FrameTimes times;
  core::FrameStatistics statistics, shown;  // the menu of a frame shows what those before it cost
  Progress progress("render", line.progress);
  for (int frame = line.firstFrame; frame < line.frames; ++frame) {
    if (progress.isDue()) progress.show(progressState(line, frame, simulation.world().stepCount()));
    while (simulation.world().stepCount() < stepOfFrame(line, frame)) {
      if (progress.isDue()) progress.show(progressState(line, frame, simulation.world().stepCount()));
      simulation.step({});
      simulation.world().takeEvents();
    }
    sceneRenderer.apply(simulation.takeLoggedChange());
    game::Snapshot now = simulation.world().now();
    simulation.warnOfGround(now);
    // The error is known when both pictures are drawn, and is written over them.
    if (split) split->makeWhole(now, size);
    if (split && split->isCoarser()) warn(kCoarserLand);
    const std::optional<ui::SplitLabels> labels =
        split ? std::optional(splitLabels(*split, run->settings.view.split)) : std::nullopt;
    if (overlay) {
      OverlayFrame content{now, size, 0, run->table};
      content.scale = {run->settings.view.interfaceScale};
      const render::View eye = sceneRenderer.view(now, size);
      if (run->settings.view.marks)
        content.eye =
            ui::Eye{eye.position, eye.worldToView, eye.fovYRad, double(eye.width), double(eye.height)};
      content.instruments = showsInstruments(run->settings.view);
      content.statistics = &shown;
      if (labels) content.split = &*labels;
      const std::vector<core::FiredGuard> fired = guards.look();
      if (run->settings.render.guardMarks) content.guards = &fired;
      std::optional<ui::WeatherBarContent> weatherBar;
      if (showsBar && !split) {
        weatherBar = weatherBarData.content(run->setup.forecast, run->settings, now.simulatedSeconds,
                                            sceneRenderer.view(now, size).position, {}, false);
        content.weatherBar = &*weatherBar;
      }
      content.tools =
          menuController.tools(run->baseTable, sceneRenderer.view(now, size), times.newest(times.count()));
      buildTwice(*overlay, content, sceneRenderer);
    }
    sceneRenderer.renderer().finish();
    const Stopwatch drawing;
    if (split) {
      split->draw(now, size, 0);
    } else {
      sceneRenderer.draw(now, size, Streaming::settled);
    }
    sceneRenderer.renderer().finish();
    times.add(drawing.ms() - sceneRenderer.settleMs());
    statistics.other["settle"] += sceneRenderer.settleMs();

    const Stopwatch reading;
    const core::Image image = sceneRenderer.renderer().readBack();
    statistics.other["readBack"] += reading.ms();
    const render::View seen = sceneRenderer.view(now, size);
    const std::string distances =
        photo ? compared(*photo, sceneRenderer, image, seen, frame, now.simulatedSeconds, run->settings)
              : std::string();
    const Stopwatch writing;
    files.write(frame, photo ? photo->shown(image, seen) : image, pictureTexts(*run, now, seen));
    statistics.other["png"] += writing.ms();
    if (overlay && overlay->showsCosts()) {
      shown = {};
      simulation.writeTo(shown);
      sceneRenderer.writeTo(shown);
      noteIdle(shown, overlay.get());
    }
    progress.clear();
    if (split) split->writeTo(statistics);
    if (line.out != "-") {
      print("%s\n", files.path(frame).c_str());
      if (photo) print("%s\n", distances.c_str());
      if (split) print("%s\n", splitLine(statistics.split).c_str());
    }
    if (run->recorder) run->recorder->flush();
  }
  for (const std::string& message : sceneRenderer.takeMessages()) warn(message);
  if (photo) photo->finish();

  if (stats) {
    times.writeTo(statistics);
    simulation.writeTo(statistics);
    sceneRenderer.writeTo(statistics);
    if (overlay) overlay->writeTo(statistics);
    noteIdle(statistics, overlay.get());
    writeStatistics(*stats, statistics);
  }
  return endFlight(simulation, run->recorder.get());
}

}  // namespace skydrop::app
