// Changes while flying: from menu, presets and files to those that depend on them, and back to the last good
// state where one fails.
#include <algorithm>
#include <chrono>
#include <exception>
#include <string>
#include <utility>

#include "app/console/message.h"
#include "app/session/land_files.h"
#include "app/session/lightning_effect.h"
#include "app/window/fault_parts.h"
#include "app/window/window_game.h"
#include "skydrop/core/error.h"

namespace skydrop::app {
namespace {

using Clock = std::chrono::steady_clock;

// What an effect that comes may add to a frame, beside the program that is compiled last.
constexpr double kShareOfFrame = 0.5, kLongestFrameMs = 200;

constexpr std::string_view kClockOffsetRow = "render.sun.offsetSeconds";

constexpr auto kWatchPeriod = std::chrono::milliseconds(500);  // of files that may be edited while flying

}  // namespace

// Who takes what over when it changes. The simulation comes first: it refuses what is unusable.
void WindowGame::registerDependents() {
  simulationDependencies_.add({"effects", "aircraft", "package", "game", "delivery", "assist", "autopilot",
                               "wind", "weather", "live", "landingLight"},
                              [this](const SettingsChange& change) { simulation_->apply(change); });
  // The hour of a forecast follows the clock of the sky.
  simulationDependencies_.add({"weatherFile", "render.sun"}, [this](const SettingsChange& change) {
    if (run_->setup.forecast) simulation_->apply(change);
  });
  presentationDependencies_.add({"effects"}, [this](const SettingsChange&) { endSplit(); });
  presentationDependencies_.add({"effects"}, [this](const SettingsChange&) { switchEffects(); });
  // Of every change, because the rows of the effect table say which settings they take.
  presentationDependencies_.add({""},
                                [this](const SettingsChange& change) { sceneRenderer_->apply(change); });
  presentationDependencies_.add({"view"}, [this](const SettingsChange&) {
    window_.apply(run_->settings.view);
    camera_.follow(*sceneRenderer_, isFrozen());
  });
  presentationDependencies_.add({""}, [this](const SettingsChange& change) { followSplit(change); });
  presentationDependencies_.add({""}, [this](const SettingsChange&) {
    if (costs_) costs_->knobs = knobStands(costs_->fronts.results, run_->table);
  });
  presentationDependencies_.add({"audio"}, [this](const SettingsChange&) {
    if (audio_) audio_->apply(run_->settings.audio);
    if (sound_) sound_->apply(run_->settings.audio);
  });
  presentationDependencies_.add({"lightning"}, [this](const SettingsChange&) {
    if (sound_) sound_->setLightning(lightningOf(simulation_->effects(), run_->settings));
  });
}

void WindowGame::switchEffects() {
  const scene::EffectSet& effects = simulation_->effects();
  const bool hadAircraft = sceneRenderer_->effects().contains(scene::Effect::aircraft);
  const bool hasAircraft = effects.contains(scene::Effect::aircraft);
  beginPreparations();
  sceneRenderer_->beginSwitch(effects, simulation_->ground());
  preparations_.keepOnly(effects);
  overlay_->showEffects(effects);
  if (effects.contains(scene::Effect::sound)) {
    openSound();
    if (!sound_) sound_ = std::make_unique<audio::SoundScene>(*audio_, run_->settings.audio);
    sound_->setLightning(lightningOf(effects, run_->settings));
  } else {
    sound_.reset();
    audio_.reset();
  }
  if (hadAircraft == hasAircraft) return;
  run_->settings.view.camera = hasAircraft ? render::CameraMode::chase : render::CameraMode::free;
  sceneRenderer_->apply({"view.camera"});
}

// `seconds`: of the frame before, half of which may be added to this one.
void WindowGame::continueSwitch(double seconds) {
  if (!sceneRenderer_->isSwitching()) return;
  attempt(part::kChange, [&] {
    if (preparations_.pending()) return preparations_.makeParts(window_.context());
    for (const std::string& message : preparations_.takeMessages()) warn(message);
    sceneRenderer_->continueSwitch(preparations_.results(sceneRenderer_->effects()), snapshotToDraw(),
                                   kShareOfFrame * std::min(1000 * seconds, kLongestFrameMs));
  });
}

void WindowGame::carryOut(const SettingsChange& change) {
  if (change.needs(core::TakesEffect::restart, run_->table)) {
    buildScene();
  } else {
    changeNotDrawn_ = true;
  }
  apply(change);
  if (change.touches("view.frameBudgetMs") || change.touches("effects")) renewBudget();
}

void WindowGame::apply(const SettingsChange& asked) {
  SettingsChange change = asked;
  if (clockPace_.follow(run_->settings.render.sun, drawnSeconds_)) change.add(std::string(kClockOffsetRow));
  simulationDependencies_.apply(change);
  presentationDependencies_.apply(change);
}

void WindowGame::applyMenuChanges(SettingsChange picked) {
  tellOfRefusals(simulation_->takeBackFixed(picked));
  if (picked.touches(kClockOffsetRow)) clockPace_.take(run_->settings.render.sun);
  if (!picked.empty()) carryOut(takeByHand(picked));
}

void WindowGame::servePreset(const ui::PresetRequest& request) {
  MenuController::Served served;
  Settings own = ungoverned(*run_);  // a preset keeps what the player chose, not what a budget turned
  const bool saves = request.kind == ui::PresetRequest::Kind::save;
  const core::SettingsTable ownTable(own);
  try {
    served = menuController_.serve(request, saves ? ownTable : run_->table, overlay_->menu());
  } catch (const std::exception& refusal) {
    return tell(part::kPreset, refusal.what());
  }
  faults_.clear(part::kPreset);
  if (!served.changedPaths.empty()) {
    menuChangedIt_ = true;
    if (!attempt(part::kChange, [&] { applyMenuChanges(SettingsChange(served.changedPaths)); })) return;
  }
  notices_.add(served.notice);
}

bool WindowGame::attempt(std::string_view part, const std::function<void()>& change) {
  // What the player binds is in force at once, and so is the camera.
  lastGood_.bindings = run_->bindings;
  lastGood_.settings.view.camera = run_->settings.view.camera;
  try {
    change();
    faults_.clear(part);
    faults_.clear(part::kStart);  // has been read by now
    return true;
  } catch (const core::GraphicsUnavailable&) {
    throw;  // the device is lost, whatever was changed
  } catch (const std::exception& refusal) {
    tell(part, refusal.what());
    goBack();
    return false;
  }
}

// Settings, bindings, scene and the menu's steps as they were in the last frame that could be drawn.
void WindowGame::goBack() {
  SettingsChange change = goBackTo(lastGood_, *run_);
  if (std::exchange(menuChangedIt_, false)) overlay_->menu().takeBack();
  changeNotDrawn_ = false;
  if (budget_ && run_->governed != budget_->rows()) {  // what it chose last cannot be drawn
    budget_.reset();
    change.add(govern(*run_, {}));
    announce("the frame budget has ended: what it chose cannot be drawn", "The frame budget has ended");
  }
  if (!(controls_.input().bindings() == run_->bindings)) controls_.bindingsWereReplaced();
  apply(change);
}

// Shaders, the scene and the player's settings take effect when they are written; what is broken is shown and
// changes nothing.
void WindowGame::watchFiles() {
  if (Clock::now() < nextWatch_) return;
  nextWatch_ = Clock::now() + kWatchPeriod;
  for (const std::string& message : sceneRenderer_->takeMessages()) tell(part::kShaders, message);
  if (const std::string_view standing = sceneRenderer_->standingError(); standing.empty()) {
    faults_.clear(part::kShaders);
  } else {
    faults_.set(part::kShaders, std::string(standing));  // another one may have been repaired
  }
  followRenewal();
  if (sceneFile_.wasWritten()) attempt(part::kScene, [this] { reloadSceneFile(); });
  if (landFiles_.wereWritten()) attempt(part::kLand, [this] { reloadLandFiles(); });
  if (playerFile_.wasWritten()) attempt(part::kPlayersFile, [this] { reloadPlayerFile(); });
}

void WindowGame::reloadSceneFile() {
  if (run_->recorder) return tellOfRefusals({"The scene stays as it was while a flight is recorded"});
  const SettingsChange change = reloadScene(*run_, line_);
  buildScene();
  apply(change);
  watchLand();
  notices_.add("The scene was reloaded");
}

void WindowGame::watchLand() {
  if (!line_.replay) landFiles_ = FilesWatch(filesOfLand(line_, run_->setup.scene));
}

void WindowGame::reloadLandFiles() {
  if (run_->recorder) return tellOfRefusals({"The land stays as it was while a flight is recorded"});
  const SettingsChange change = reloadLand(*run_, line_);
  buildScene();
  apply(change);
  notices_.add("The land was reloaded");
}

void WindowGame::reloadPlayerFile() {
  std::vector<std::string> refused;
  const SettingsChange change = reloadPlayer(*run_, &refused);
  tellOfRefusals(refused);
  controls_.bindingsWereReplaced();
  carryOut(change);
  if (run_->warning) {
    tell(part::kPlayersValues, *run_->warning);
  } else {
    faults_.clear(part::kPlayersValues);
  }
  notices_.add("The settings were reloaded");
}

void WindowGame::tellOfRefusals(const std::vector<std::string>& reasons) {
  for (const std::string& reason : reasons) announce(reason, reason);
}

// On stderr once, and in the menu until it is repaired.
void WindowGame::tell(std::string_view part, const std::string& line) {
  if (faults_.set(part, line)) warn(line);
}

// What the player should know now, and find again in the terminal.
void WindowGame::announce(const std::string& line, const std::string& notice) {
  warn(line);
  notices_.add(notice, Notices::kUnrequestedSeconds);
}

}  // namespace skydrop::app
