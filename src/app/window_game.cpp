#include "app/window_game.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <utility>

#include "app/statistics_json.h"
#include "app/user_settings.h"
#include "skydrop/core/error.h"

namespace skydrop::app {
namespace {

using Clock = std::chrono::steady_clock;
using scene::Effect;

constexpr Size kDefaultSize{1280, 720};
constexpr double kNoticeSeconds = 3;
constexpr auto kWatchPeriod = std::chrono::milliseconds(500);  // of files that may be edited while flying
constexpr auto kStatisticsPeriod = std::chrono::milliseconds(500);  // of the table in the menu and of --stats
constexpr std::size_t kShownFrames = 240;                           // in the graph of the menu
constexpr double kFreeCameraSpeed = 120;                            // m/s
constexpr double kFreeCameraTurn = 1.2;                             // rad/s

volatile std::sig_atomic_t endRequested = 0;

void requestEnd(int) { endRequested = 1; }

render::gl::WindowSettings windowSettings(const CommandLine& line) {
  const Size size = line.size.value_or(kDefaultSize);
  return {.width = size.width, .height = size.height, .title = "Skydrop", .fullScreen = line.fullscreen};
}

std::filesystem::file_time_type timeOf(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::last_write_time(file, ignored);
}

std::string timeStamp() {
  const std::time_t now = std::time(nullptr);
  char text[32];
  std::strftime(text, sizeof text, "%Y%m%d-%H%M%S", std::localtime(&now));
  return text;
}

class WindowClipboard final : public Clipboard {
 public:
  explicit WindowClipboard(render::gl::WindowContext& window) : window_(window) {}
  std::string text() override { return window_.clipboardText(); }
  void setText(const std::string& text) override { window_.setClipboardText(text); }

 private:
  render::gl::WindowContext& window_;
};

std::filesystem::path gamepadMappings(const Run& run) {
  return run.userFolder ? *run.userFolder / "gamecontrollerdb.txt" : std::filesystem::path();
}

}  // namespace

WindowGame::WindowGame(const CommandLine& line)
    : line_(line),
      run_(prepareRun(line)),
      window_(windowSettings(line)),
      clipboard_(std::make_unique<WindowClipboard>(window_)),
      joysticks_(gamepadMappings(*run_)),
      controls_(run_->bindings, run_->settings.input.gamepad, joysticks_),
      desk_(run_->userFolder) {
  window_.setVsync(true);
  overlay_ = std::make_unique<Overlay>(scene::requiredEffects(run_->setup.scene),
                                       Size{window_.width(), window_.height()}, controls_.help());
  imguiInput_.emplace(clipboard_.get());
  controls_.setKeyLabels(keyboardLabels());
  buildScene();
  sceneWritten_ = timeOf(run_->setup.scene.file);
  if (run_->userFolder) playerWritten_ = timeOf(userSettingsFile(*run_->userFolder));
  if (const auto warning = desk_.load(overlay_->menu())) {
    std::fprintf(stderr, "skydrop: %s\n", warning->c_str());
    error_ = *warning;
  }
  if (run_->warning) {
    std::fprintf(stderr, "skydrop: %s\n", run_->warning->c_str());
    error_ = *run_->warning;
  }
  std::signal(SIGINT, requestEnd);
  std::signal(SIGTERM, requestEnd);
}

WindowGame::~WindowGame() = default;

// Everything that a scene's effects call for, anew.
void WindowGame::buildScene() {
  sound_.reset();
  stage_.reset();
  simulation_.emplace(run_->setup, run_->settings, run_->table);
  const scene::EffectSet& effects = simulation_->effects();
  stage_ = std::make_unique<Stage>(
      window_, Stage::Setup{effects, simulation_->ground(), line_.workers, line_.stats.has_value()},
      run_->settings);
  stage_->addOverlay();
  stage_->warmUp(simulation_->world().now(), {window_.width(), window_.height()});
  if (effects.contains(Effect::sound)) {
    if (!audio_) {
      audio_ = std::make_unique<audio::AudioManager>(run_->settings.audio);
      if (audio_->isSilent()) std::fprintf(stderr, "skydrop: %s\n", audio_->status().c_str());
    }
    sound_ = std::make_unique<audio::SoundScene>(*audio_, run_->settings.audio);
  }
  clock_ = {};
  events_.clear();
}

void WindowGame::run() {
  auto last = Clock::now();
  while (!window_.shouldClose() && !endRequested) {
    const auto now = Clock::now();
    const double seconds = std::chrono::duration<double>(now - last).count();
    last = now;
    handleEvents();
    watchFiles();
    advance(seconds);
    drawFrame(seconds);
    window_.swap();
    times_.add(std::chrono::duration<double, std::milli>(Clock::now() - now).count());
  }
  finish();
}

void WindowGame::handleEvents() {
  using Kind = render::gl::WindowEvent::Kind;
  bool lostFocus = false;
  for (const render::gl::WindowEvent& event : window_.pollEvents()) {
    if (event.kind == Kind::focus) lostFocus = !event.pressed;
    if (event.kind == Kind::mouseMove) pointerMoved_ = true;
    const bool ofMenu = overlay_->menuOpen && ImGuiInput::isMenuChord(event);
    if (controls_.handle(event, ImGuiInput::wantsText() || ofMenu)) continue;
    imguiInput_->handle(event, window_.pixelsPerUnit());
  }
  for (const render::gl::WindowEvent& event : controls_.pollGamepad(overlay_->escapeOpen))
    imguiInput_->handle(event);
  // What comes back at once was not lost: a window that opens under the mouse sees the focus come, go and
  // come.
  if (lostFocus) paused_ = true;
  for (const Action action : controls_.input().takeActions()) handleAction(action);
  showControls();
}

// What the player steers with, wherever it is told.
void WindowGame::showControls() {
  for (const GamepadMessage& message : controls_.takeMessages()) {
    std::fprintf(stderr, "skydrop: %s\n", message.text.c_str());
    if (message.isNews) notice(message.text);
  }
  if (!overlay_->menuOpen) controls_.stopWaiting();
  if (controls_.takeChange()) overlay_->showKeys(controls_.help(), controls_.hudKeys());
}

void WindowGame::handleAction(Action action) {
  switch (action) {
    case Action::camera:
      stage_->camera().nextMode();
      if (stage_->camera().mode() == render::CameraMode::free) stage_->freeCamera();
      rideAgain_.reset();
      run_->settings.view.camera = stage_->camera().mode();
      notice("Camera: " + std::string(render::cameraModeName(stage_->camera().mode())));
      break;
    case Action::pause:
      paused_ = !paused_;
      break;
    case Action::help:
      overlay_->helpOpen = !overlay_->helpOpen;
      break;
    case Action::menu:
      overlay_->menuOpen = !overlay_->menuOpen;
      break;
    case Action::escape:
      overlay_->escapeOpen = !overlay_->escapeOpen;
      break;
    case Action::fullScreen:
      window_.setFullScreen(!window_.isFullScreen());
      break;
    case Action::screenshot:
      screenshotWanted_ = true;
      break;
    case Action::freeze:
      toggle("view.freezeTime");
      notice(isFrozen() ? "Time is frozen: the keys move the camera" : "Time goes on");
      break;
    case Action::mute:
      toggle("audio.mute");
      notice(run_->settings.audio.mute ? "Sound off" : "Sound on");
      break;
    default:
      break;  // flight actions: PlayerInput::step
  }
}

// A flag by its key, as if in the menu.
void WindowGame::toggle(const std::string& path) {
  const core::Field& flag = run_->table.at(path);
  core::setField(flag, flag.get() != 0 ? 0.0 : 1.0);
  applyMenuChanges({path});
}

// While time is held the camera is free where it was; afterwards it rides again, unless another was chosen.
void WindowGame::freezeOrGoOn() {
  render::Camera& camera = stage_->camera();
  if (isFrozen() && camera.mode() != render::CameraMode::free) {
    rideAgain_ = camera.mode();
    stage_->freeCamera();
  } else if (!isFrozen() && rideAgain_) {
    camera.setMode(*std::exchange(rideAgain_, std::nullopt));
  }
}

void WindowGame::advance(double seconds) {
  for (game::Message& message : notices_) message.secondsLeft -= seconds;
  std::erase_if(notices_, [](const game::Message& message) { return message.secondsLeft <= 0; });
  if (isPaused()) {
    clock_.discardPending();
    controls_.input().forgetTaps();
    return;
  }
  for (int due = clock_.advance(seconds); due > 0; --due) {
    game::Controls controls = controls_.input().step();
    if (stage_->camera().mode() == render::CameraMode::free) {
      moveFreeCamera(controls);
      controls = {};
    }
    if (isFrozen()) continue;
    simulation_->step(controls);
    const std::vector<game::GameEvent> events = simulation_->world().takeEvents();
    events_.insert(events_.end(), events.begin(), events.end());
  }
  if (simulation_->finished() && !replayEnded_) {
    replayEnded_ = true;
    paused_ = true;
    notice("The replay has ended");
  }
}

// The keys of the aircraft move the free camera: thrust and brake along the view, roll turns, pitch looks up
// and down, yaw climbs and sinks. The aircraft flies on by itself.
void WindowGame::moveFreeCamera(const game::Controls& controls) {
  render::Camera& camera = stage_->camera();
  const double metres = kFreeCameraSpeed * core::FixedStep::kStepSeconds;
  const double radians = kFreeCameraTurn * core::FixedStep::kStepSeconds;
  camera.move({0, controls.yaw * metres, (controls.thrust - controls.brake) * metres});
  camera.turn(controls.roll * radians, -controls.pitch * radians);
}

game::Snapshot WindowGame::snapshotToDraw() {
  game::Snapshot snapshot = simulation_->world().interpolated(isPaused() || isFrozen() ? 1 : clock_.alpha());
  snapshot.autopilot = simulation_->pilot() == Pilot::autopilot;
  snapshot.paused = isPaused();
  snapshot.frozen = isFrozen();
  snapshot.messages.insert(snapshot.messages.end(), notices_.begin(), notices_.end());
  return snapshot;
}

void WindowGame::drawFrame(double seconds) {
  const game::Snapshot snapshot = snapshotToDraw();
  const Size size{window_.width(), window_.height()};
  if (sound_) {
    audio_->setPaused(isPaused() || isFrozen());
    sound_->update(snapshot, events_);
  }
  events_.clear();
  stage_->setMeasuring(line_.stats.has_value() || overlay_->showsCosts());
  if (overlay_->showsCosts() && Clock::now() >= nextStatistics_) shownStatistics_ = statistics(kShownFrames);

  imguiInput_->beginFrame();
  overlay_->hudShown = run_->settings.view.hud;
  const bool pointerNeeded = overlay_->menuOpen || overlay_->escapeOpen;
  window_.setPointerVisible(pointer_.isShown(seconds, std::exchange(pointerMoved_, false), pointerNeeded));
  const ui::BindingsContent bindings = controls_.menuContent();
  const OverlayResult result = overlay_->build({snapshot, size, seconds, run_->table, &shownStatistics_, error_,
                                                menuTools(snapshot, size), &bindings});
  if (result.fontsChanged) stage_->uploadFonts();
  stage_->draw(snapshot, size, Streaming::asItComes);
  if (screenshotWanted_) saveScreenshot();
  stage_->renderer().present(size.width, size.height);

  if (Clock::now() >= nextStatistics_) {
    nextStatistics_ = Clock::now() + kStatisticsPeriod;
    if (line_.stats) writeStatistics(*line_.stats, statistics());
  }
  // What the player did in this frame takes effect after it was drawn.
  controls_.apply(result.menu.binding);
  if (!result.menu.changedPaths.empty()) applyMenuChanges(result.menu.changedPaths);
  if (result.menu.preset) servePreset(*result.menu.preset);
  switch (result.escape) {
    case ui::EscapeAction::none:
      break;
    case ui::EscapeAction::resume:
      overlay_->escapeOpen = false, paused_ = false;
      break;
    case ui::EscapeAction::help:
      overlay_->escapeOpen = false, overlay_->helpOpen = true;
      break;
    case ui::EscapeAction::quit:
      window_.setShouldClose(true);
      break;
  }
}

ui::MenuTools WindowGame::menuTools(const game::Snapshot& snapshot, Size size) {
  if (!overlay_->menuOpen) return {};
  return desk_.tools(run_->baseTable, stage_->view(snapshot, size), times_.newest(kShownFrames));
}

void WindowGame::servePreset(const ui::PresetRequest& request) {
  try {
    const MenuDesk::Served served = desk_.serve(request, run_->table, overlay_->menu());
    error_.clear();
    notice(served.notice);
    if (!served.changedPaths.empty()) applyMenuChanges(served.changedPaths);
  } catch (const std::exception& refusal) {
    error_ = refusal.what();
  }
}

void WindowGame::applyMenuChanges(const std::vector<std::string>& paths) {
  for (const std::string& path : paths) run_->playerTable.at(path).set(run_->table.at(path).get());
  applyAll(paths);
}

void WindowGame::applyAll(const std::vector<std::string>& changedPaths) {
  const bool needsNewLand = std::any_of(changedPaths.begin(), changedPaths.end(),
                                        [](const std::string& path) { return path.starts_with("terrain."); });
  if (needsNewLand && run_->setup.record) {
    notice("The land keeps its shape while a flight is recorded");
  } else if (needsNewLand) {
    buildScene();
    return;
  }
  simulation_->applySettings(changedPaths);
  stage_->apply(run_->settings);
  freezeOrGoOn();
  if (audio_) audio_->apply(run_->settings.audio);
  if (sound_) sound_->apply(run_->settings.audio);
}

// Shaders, the scene and the player's settings take effect when they are written; what is broken is shown and
// changes nothing.
void WindowGame::watchFiles() {
  if (Clock::now() < nextWatch_) return;
  nextWatch_ = Clock::now() + kWatchPeriod;
  for (const std::string& message : stage_->takeMessages()) error_ = message;
  const auto wasWritten = [](const std::filesystem::path& file, std::filesystem::file_time_type& seen) {
    return timeOf(file) != std::exchange(seen, timeOf(file)) && std::filesystem::exists(file);
  };
  try {
    if (wasWritten(run_->setup.scene.file, sceneWritten_)) reloadSceneFile();
    if (run_->userFolder && wasWritten(userSettingsFile(*run_->userFolder), playerWritten_))
      reloadPlayerFile();
  } catch (const std::exception& refusal) {
    error_ = refusal.what();
  }
}

void WindowGame::reloadSceneFile() {
  reloadScene(*run_, line_);
  error_.clear();
  buildScene();
  notice("The scene was loaded anew");
}

void WindowGame::reloadPlayerFile() {
  const std::vector<std::string> changed = reloadPlayer(*run_, line_);
  error_.clear();
  controls_.bindingsWereReplaced();
  applyAll(changed);
  notice("The settings were loaded anew");
}

void WindowGame::saveScreenshot() {
  screenshotWanted_ = false;
  const std::filesystem::path folder = run_->userFolder ? *run_->userFolder / "screenshots" : "screenshots";
  const std::filesystem::path file =
      folder / ("skydrop-" + timeStamp() + "-" + std::to_string(screenshots_ + 1) + ".png");
  try {
    std::filesystem::create_directories(folder);
    core::writePng(file, stage_->renderer().readBack());
    ++screenshots_;
    notice("Saved " + file.string());
  } catch (const std::exception& refusal) {
    error_ = refusal.what();
    notice(error_);
  }
}

void WindowGame::notice(std::string text) { notices_.push_back({std::move(text), kNoticeSeconds}); }

core::FrameStatistics WindowGame::statistics(std::size_t frames) {
  core::FrameStatistics statistics;
  times_.writeTo(statistics);
  simulation_->writeTo(statistics);
  stage_->writeTo(statistics, frames);
  core::WindowStatistics& window = statistics.window;
  window.width = window_.width();
  window.height = window_.height();
  window.camera = render::cameraModeName(stage_->camera().mode());
  window.menuOpen = overlay_->menuOpen;
  window.helpOpen = overlay_->helpOpen;
  window.escapeOpen = overlay_->escapeOpen;
  window.paused = isPaused();
  window.frozen = isFrozen();
  window.fullScreen = window_.isFullScreen();
  window.screenshots = screenshots_;
  return statistics;
}

void WindowGame::finish() {
  stage_->renderer().finish();
  if (line_.stats) writeStatistics(*line_.stats, statistics());
  if (line_.record) game::writeInputLog(*line_.record, simulation_->recording());
  if (run_->userFolder)
    saveUserSettings(run_->playerTable, run_->baseTable, run_->bindings, *run_->userFolder);
  desk_.save(overlay_->menu());
}

}  // namespace skydrop::app
