#include "app/window/window_game.h"

#include <algorithm>
#include <csignal>
#include <exception>
#include <utility>

#include "app/console/message.h"
#include "app/console/standard_output.h"
#include "app/measure/system_info.h"
#include "app/session/lightning_effect.h"
#include "app/session/start_camera.h"
#include "app/settings/quality_preset.h"
#include "app/settings/user_settings.h"
#include "app/window/fault_parts.h"
#include "app/window/laboratory_run.h"
#include "app/window/split_texts.h"
#include "app/window/window_clipboard.h"
#include "skydrop/core/error.h"
#include "skydrop/render/frame/sky_clock.h"
#include "skydrop/sky/instant.h"

namespace skydrop::app {
namespace {

using Clock = std::chrono::steady_clock;
using scene::Effect;

constexpr auto kStatisticsPeriod = std::chrono::milliseconds(500);  // of the table in the menu
constexpr std::size_t kShownFrames = 240;                           // in the graph of the menu

volatile std::sig_atomic_t endRequested = 0;

void requestEnd(int) { endRequested = 1; }

// Who started the game may have it ignore a signal (nohup).
void endOn(int signal) {
  if (std::signal(signal, requestEnd) == SIG_IGN) std::signal(signal, SIG_IGN);
}

std::filesystem::path screenshotFolder(const RunConfig& run) {
  return run.userFolder ? *run.userFolder / "screenshots" : "screenshots";
}

// Why settings and screenshots will not be kept, known before the flight.
std::optional<std::string> folderRefusal(const RunConfig& run) {
  try {
    if (run.userFolder) core::requireFolder(*run.userFolder);
    core::requireFolder(screenshotFolder(run));
    return std::nullopt;
  } catch (const core::DataError& refusal) {
    return refusal.what();
  }
}

std::filesystem::path gamepadMappings(const RunConfig& run) {
  return run.userFolder ? *run.userFolder / "gamecontrollerdb.txt" : std::filesystem::path();
}

}  // namespace

WindowGame::WindowGame(const CommandLine& line)
    : line_(line),
      run_(prepareRun(line)),
      stats_(openOutput(line.stats)),
      window_(line),
      clipboard_(std::make_unique<WindowClipboard>(window_.context())),
      joysticks_(gamepadMappings(*run_)),
      controls_(run_->bindings, run_->settings.input.gamepad, joysticks_),
      menuController_(run_->userFolder),
      screenshots_(screenshotFolder(*run_)) {
  if (window_.context().isSoftware()) useSoftwareRenderer(*run_);
  if (line_.pose) run_->settings.view.camera = render::CameraMode::free;
  registerDependents();
  beginPreparations();
  std::vector<std::string> warnings;
  if (run_->warning) tell(part::kPlayersValues, *run_->warning);
  if (const auto warning = folderRefusal(*run_)) tell(part::kChoices, *warning);
  if (!joysticks_.warning().empty()) warnings.push_back(joysticks_.warning());
  warnings.insert(warnings.end(), run_->notes.begin(), run_->notes.end());
  window_.apply(run_->settings.view);
  for (std::string& warning : window_.show(readQualityPreset(run_->quality).window, run_->userFolder)) {
    warnings.push_back(std::move(warning));
  }
  overlay_ =
      std::make_unique<Overlay>(effectsOf(*run_), window_.size(), controls_.help(), window_.interfaceScale());
  imguiInput_.emplace(clipboard_.get());
  feed_.emplace(*imguiInput_);
  controls_.setKeyLabels(keyboardLabels());
  if (line_.photo) photo_.emplace(window_.context(), *line_.photo);
  if (auto warning = menuController_.load(overlay_->menu())) warnings.push_back(std::move(*warning));
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, requestEnd);
#ifdef SIGHUP
  endOn(SIGHUP);  // the terminal was closed
#endif
  for (const std::string& warning : warnings) tell(part::kStart, warning);
  tellOfSoftware();
  buildScene();
  attempt(part::kChange, [this] { renewBudget(); });
  if (run_->userFolder) best_ = BestResults(*run_->userFolder);
  if (const auto warning = best_.load()) tell(part::kChoices, *warning);
  beginBriefing();
  beginRenewal();
  loadedMs_ = 1000 * secondsSinceStart();
  if (!line_.replay) sceneFile_ = FileWatch(run_->setup.scene.file);
  watchLand();
  if (run_->userFolder) playerFile_ = FileWatch(userSettingsFile(*run_->userFolder));
}

WindowGame::~WindowGame() = default;

// Without a graphics card the game starts small and coarse; the player should know why, and what to do.
void WindowGame::tellOfSoftware() {
  if (!run_->softwareRenderer || run_->settings.quality != Quality::automatic) return;
  warn("the processor draws (" + window_.context().renderer() + "): quality " +
       std::string(kQualityNames[static_cast<std::size_t>(run_->quality)]) +
       "; --set quality=high, or the menu (F1)");
  if (window_.takeSoftwareNews()) {
    notices_.add("No graphics card: low quality, a small window. F1 changes that.",
                 Notices::kUnrequestedSeconds);
  }
}

// Beside everything else.
void WindowGame::beginPreparations() {
  using Maker = Preparation::Maker;
  preparations_.begin(effectsOf(*run_), window_.context().isSoftware() ? Maker::processor : Maker::graphics,
                      run_->settings);
}

// Everything that the scene's effects call for, beside what there is. Without a sceneRenderer when the player
// quit.
WindowGame::Flight WindowGame::loadFlight(bool& lostFocus) {
  beginPreparations();
  Flight next;
  Loading loading(window_, *overlay_, [&] {
    handleEventsWhileLoading(lostFocus);
    return !ends();
  });
  if (!loading.prepare(preparations_)) return next;
  for (const std::string& message : preparations_.takeMessages()) warn(message);
  faceTarget();
  next.simulation = std::make_unique<Simulation>(run_->setup, run_->settings, run_->table);
  const scene::EffectSet& effects = next.simulation->effects();
  const SceneRenderer::Setup setup{.effects = effects,
                                   .ground = next.simulation->ground(),
                                   .workers = line_.workers,
                                   .measuring = stats_.has_value(),
                                   .prepared = preparations_.results(effects),
                                   .compilesAhead = true,
                                   .framesFollow = true,
                                   .images = next.simulation->images()};
  next.sceneRenderer = std::make_unique<SceneRenderer>(window_.context(), setup, run_->settings);
  if (sceneRenderer_) {
    next.sceneRenderer->camera() = sceneRenderer_->camera();
  } else if (line_.pose) {
    placeCamera(next.sceneRenderer->camera(), *line_.pose, *next.simulation->ground());
    if (const auto warning = underSurface(next.sceneRenderer->camera(), *next.simulation->ground()))
      warn(*warning);
  }
  next.sceneRenderer->addOverlay();
  if (effects.contains(Effect::sound)) {
    openSound();
    next.sound = std::make_unique<audio::SoundScene>(*audio_, run_->settings.audio);
    next.sound->setLightning(lightningOf(effects, run_->settings));
  }
  loading.makeLand(*next.sceneRenderer, next.simulation->world().now());
  return next;
}

// The flight of the present scene in place of the one before it, which goes on where the new one cannot be
// made: then this throws. Time does not begin before the land in view is there. Changes nothing when the
// player quits.
void WindowGame::buildScene() {
  if (audio_) audio_->setPaused(true);
  bool lostFocus = false;
  std::exception_ptr failure;
  try {
    if (Flight next = loadFlight(lostFocus); next.sceneRenderer) {
      overlay_->showEffects(next.simulation->effects());
      sound_ = std::move(next.sound);
      if (!sound_) audio_.reset();
      endSplit();
      sceneRenderer_ = std::move(next.sceneRenderer);
      simulation_ = std::move(next.simulation);
      lastGood_ = choicesOf(*run_);
      changeNotDrawn_ = menuChangedIt_ = false;
      clock_ = {};
      clockPace_.restart();
      if (clockPace_.follow(run_->settings.render.sun, 0)) sceneRenderer_->apply({"render.sun"});
      drawnSeconds_ = 0;
      events_.clear();
      beginDeliveries();
    }
  } catch (...) {
    failure = std::current_exception();
  }
  preparations_.keepOnly(simulation_ ? simulation_->effects() : scene::EffectSet());
  if (lostFocus) paused_ = true;
  if (budget_) budget_->forgetFrames();
  if (sceneRenderer_) sceneRenderer_->uploadFonts();  // the loading picture had its own
  programsLoaded_ = window_.context().resources().live(render::gl::ObjectKind::program);
  lastFrame_ = Clock::now();
  if (failure) std::rethrow_exception(failure);
}

void WindowGame::handleEventsWhileLoading(bool& lostFocus) {
  using Kind = render::gl::WindowEvent::Kind;
  for (const render::gl::WindowEvent& event : window_.pollEvents()) {
    if (event.kind == Kind::key && event.code == key::kEscape && event.pressed)
      window_.context().setShouldClose(true);
    if (event.kind == Kind::focus) lostFocus = !event.pressed;
    // What is pressed now is meant for nobody; what was held may be let go.
    const bool presses = (event.kind == Kind::key || event.kind == Kind::mouseButton) && event.pressed;
    if (!presses && event.kind != Kind::character) feed_->add(event, window_.context().pixelsPerUnit());
  }
}

int WindowGame::run() {
  std::exception_ptr failure;
  try {
    fly();
  } catch (...) {
    failure = std::current_exception();
  }
  finish(failure);
  return run_->recorder && run_->recorder->isIncomplete() ? 1 : 0;
}

void WindowGame::fly() {
  lastFrame_ = Clock::now();
  while (!ends()) {
    if (!sceneRenderer_) break;
    const auto now = Clock::now();
    const double seconds = std::chrono::duration<double>(now - std::exchange(lastFrame_, now)).count();
    handleEvents();
    if (std::exchange(laboratoryWanted_, false)) visitLaboratory();
    watchFiles();
    if (saveChoicesPending_ && !changeNotDrawn_) {
      saveChoicesPending_ = false;
      keepChoices();
    }
    if (window_.isHidden()) paused_ = true;
    advance(seconds);
    continueSwitch(seconds);
    renewLostSound();
    if (!window_.isHidden()) {
      drawFrame(seconds);
      const auto drawn = Clock::now();
      window_.swap();
      const std::chrono::duration<double, std::milli> frame = Clock::now() - now;
      times_.add(frame.count());
      if (budget_)
        followBudget(std::chrono::duration<double, std::milli>(drawn - now).count(), frame.count());
      window_.waitForNextFrame();
    }
    report();
    keepRecording();
  }
}

void WindowGame::visitLaboratory() {
  try {
    runLaboratory({});
  } catch (const core::GraphicsUnavailable& refusal) {
    announce(refusal.what(), "The laboratory does not open");
  } catch (const core::DataError& refusal) {
    announce(refusal.what(), "The laboratory does not open");
  }
  window_.context().makeCurrent();
  overlay_->makeCurrent();
  lastFrame_ = Clock::now();  // no time has passed here
}

bool WindowGame::wasAskedToEnd() { return endRequested != 0; }

bool WindowGame::ends() { return window_.context().shouldClose() || endRequested; }

void WindowGame::advance(double seconds) {
  notices_.pass(seconds);
  if (isPaused()) {
    clock_.discardPending();
    controls_.input().forgetTaps();
    return;
  }
  for (int due = clock_.advance(seconds); due > 0; --due) {
    game::Controls controls = controls_.input().step();
    if (sceneRenderer_->camera().mode() == render::CameraMode::free) {
      PlayerCamera::move(sceneRenderer_->camera(), controls);
      controls = {};  // the aircraft flies on by itself
    }
    if (isFrozen()) continue;
    simulation_->step(controls);
    noteDeliveries();
    followLesson();
    if (const auto divergence = simulation_->takeDivergence())
      announce(*divergence, "The replay differs from the recorded flight");
    const std::vector<game::GameEvent> events = simulation_->world().takeEvents();
    events_.insert(events_.end(), events.begin(), events.end());
  }
  // A replay changes settings as its log says; the world has them already.
  presentationDependencies_.apply(simulation_->takeLoggedChange());
  if (simulation_->pilot() == Pilot::replay && !changeNotDrawn_) lastGood_ = choicesOf(*run_);
  if (simulation_->finished() && !replayEnded_) {
    replayEnded_ = true;
    paused_ = true;
    notices_.add("The replay has ended");
  }
}

game::Snapshot WindowGame::snapshotToDraw() {
  game::Snapshot snapshot = simulation_->world().interpolated(isPaused() || isFrozen() ? 1 : clock_.alpha());
  snapshot.autopilot = simulation_->pilot() == Pilot::autopilot;
  snapshot.paused = isPaused();
  snapshot.frozen = isFrozen();
  simulation_->warnOfGround(snapshot);
  notices_.addTo(snapshot);
  if (lesson_) snapshot.messages.push_back({lessonText(), 1});
  return snapshot;
}

void WindowGame::drawFrame(double seconds) {
  releaseFreeze();
  const game::Snapshot snapshot = snapshotToDraw();
  drawnSeconds_ = snapshot.simulatedSeconds;
  const Size size = window_.size();
  sceneRenderer_->leaveRoomToTheLeft(photo_ && !split_ && run_->settings.view.photo == PhotoView::beside);
  if (sound_) {
    soundCost_.measure([&] { hear(snapshot, size); });
    soundCost_.endRound();
  }
  events_.clear();
  measureIfAsked();
  renewCosts();
  noteCosts();

  window_.context().setPointerVisible(
      pointer_.isShown(seconds, std::exchange(pointerMoved_, false), interfaceUsesPointer()));
  followPackages(snapshot, size);
  const OverlayResult result = buildInterface(snapshot, seconds);
  if (budget_) drawingSince_ = Clock::now();
  drawPicture(snapshot, result.picture);
  drawScene(snapshot, size);
  if (hasPicture_)
    sceneRenderer_->showInset(static_cast<int>(result.picture.left),
                              size.height - static_cast<int>(result.picture.bottom));
  if (screenshotWanted_) saveScreenshot(snapshot);
  sceneRenderer_->renderer().present(size.width, size.height);
  serve(result);  // what the player did in this frame takes effect after it was drawn
}

// From the next step and frame on.
void WindowGame::measureIfAsked() {
  const bool asked = stats_.has_value() || overlay_->showsCosts() || costs_;
  sceneRenderer_->setMeasuring(asked);
  simulation_->setMeasuring(asked);
  overlay_->setMeasuring(asked);
  soundCost_.setMeasuring(asked);
}

// A frame that cannot be drawn with what was chosen last is drawn with what was chosen before. What is broken
// else is left out of it, for as long as it is.
void WindowGame::drawScene(const game::Snapshot& snapshot, Size size) {
  if (changeNotDrawn_) {
    const bool drawn = attempt(part::kChange, [&] { drawSplit(snapshot, size); });
    if (drawn) {
      if (sceneRenderer_->isSwitching()) return;  // an effect that comes is not drawn yet
      lastGood_ = choicesOf(*run_);
      changeNotDrawn_ = menuChangedIt_ = false;
      return;
    }
  }
  try {
    drawSplit(snapshot, size);
    faults_.clear(part::kFrame);
  } catch (const core::DataError& broken) {
    tell(part::kFrame, broken.what());
  }
}

// One frame of the interface, with what the menus want to show.
OverlayResult WindowGame::buildInterface(const game::Snapshot& snapshot, double seconds) {
  const Size size = window_.size();
  overlay_->hudShown = run_->settings.view.hud;
  const ui::BindingsContent bindings = controls_.menuContent();
  OverlayFrame frame{snapshot,
                     size,
                     seconds,
                     run_->table,
                     &shownStatistics_,
                     faults_.shown(),
                     menuTools(snapshot, size),
                     &bindings,
                     window_.interfaceScale()};
  const std::optional<ui::SplitLabels> labels =
      split_ ? std::optional(splitLabels(*split_, run_->settings.view.split)) : std::nullopt;
  if (labels) frame.split = &*labels;
  const std::optional<ui::CostPanelContent> costs = costs_ ? std::optional(costContent()) : std::nullopt;
  if (costs) frame.costs = &*costs;
  const std::vector<core::FiredGuard> fired = guards_.look();
  if (run_->settings.render.guardMarks) frame.guards = &fired;
  const std::optional<ui::WeatherBarContent> weatherBar =
      showsWeatherBar() ? std::optional(weatherBarContent(snapshot, size)) : std::nullopt;
  if (weatherBar) frame.weatherBar = &*weatherBar;
  if (photo_ && !split_)
    frame.photo = photo_->layer(sceneRenderer_->view(snapshot, size), run_->settings.view);
  if (run_->settings.view.marks && !split_) {
    const render::View seen = sceneRenderer_->view(snapshot, size);
    frame.eye =
        ui::Eye{seen.position, seen.worldToView, seen.fovYRad, double(seen.width), double(seen.height)};
  }
  frame.instruments = showsInstruments(run_->settings.view);
  frame.panel = panel();
  if (showsPicture()) frame.pictureAspect = 16.0 / 9;
  frame.begun = [this] { feed_->frameBuilt(); };
  const OverlayResult result = overlay_->build(frame);
  if (result.fontsChanged) sceneRenderer_->uploadFonts();
  return result;
}

void WindowGame::serve(const OverlayResult& result) {
  controls_.apply(result.menu.binding);
  if (!result.menu.changedPaths.empty()) {
    menuChangedIt_ = true;
    attempt(part::kChange, [&] { applyMenuChanges(SettingsChange(result.menu.changedPaths)); });
  }
  if (result.menu.preset) servePreset(*result.menu.preset);
  if (result.costsClosed) costs_.reset();
  serve(result.weatherBar);
  if (result.divider && split_) dragDivider(*result.divider);
  if (std::exchange(menuWasOpen_, overlay_->menuOpen) && !overlay_->menuOpen) {
    nextWatch_ = {};  // an edit of a moment ago is read before what was chosen is added to it
    saveChoicesPending_ = true;
  }
  switch (result.escape) {
    case ui::EscapeAction::none:
      break;
    case ui::EscapeAction::resume:
      overlay_->escapeOpen = false, paused_ = false;
      break;
    case ui::EscapeAction::help:
      overlay_->escapeOpen = false, overlay_->helpOpen = true;
      break;
    case ui::EscapeAction::laboratory:
      laboratoryWanted_ = true;  // between two frames
      break;
    case ui::EscapeAction::quit:
      window_.context().setShouldClose(true);
      break;
  }
}

// The table is renewed by a clock of its own, at once when it is opened.
void WindowGame::renewCosts() {
  if (!overlay_->showsCosts()) {
    nextCosts_ = {};
    return;
  }
  const auto now = Clock::now();
  if (now < nextCosts_) return;
  nextCosts_ = now + kStatisticsPeriod;
  shownStatistics_ = statistics(kShownFrames);
}

ui::MenuTools WindowGame::menuTools(const game::Snapshot& snapshot, Size size) {
  if (!overlay_->menuOpen) return {};
  ui::MenuTools tools = menuController_.tools(run_->baseTable, sceneRenderer_->view(snapshot, size),
                                              times_.newest(kShownFrames));
  tools.clockMs = static_cast<double>(
      sky::instantAt(render::clockDays(run_->settings.render.sun, snapshot.simulatedSeconds)).utcMs);
  return tools;
}

}  // namespace skydrop::app
