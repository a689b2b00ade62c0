// What the game keeps of a flight: statistics, the recording, screenshots, the player's choices; and its end.
#include <chrono>
#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "app/console/message.h"
#include "app/measure/bill.h"
#include "app/measure/statistics_json.h"
#include "app/session/picture_texts.h"
#include "app/settings/user_settings.h"
#include "app/window/fault_parts.h"
#include "app/window/window_game.h"
#include "skydrop/core/error.h"

namespace skydrop::app {
namespace {

using Clock = std::chrono::steady_clock;
using scene::Effect;

constexpr auto kStatisticsPeriod = std::chrono::milliseconds(500);  // of --stats
constexpr auto kFlushPeriod = std::chrono::milliseconds(500);       // of the recording

std::string reasonOf(const std::exception_ptr& failure) {
  try {
    std::rethrow_exception(failure);
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "unknown error";
  }
}

}  // namespace

void WindowGame::report() {
  if (Clock::now() < nextStatistics_) return;
  nextStatistics_ = Clock::now() + kStatisticsPeriod;
  if (!stats_) return;
  try {
    writeStatistics(*stats_, statistics());
    faults_.clear(part::kStatistics);
  } catch (const core::ClosedPipe&) {
    stats_.reset();  // nobody reads them any more
  } catch (const std::exception& refusal) {
    tell(part::kStatistics, refusal.what());
  }
}

// By the clock on the wall: where frames are slow, simulated seconds are long.
void WindowGame::keepRecording() {
  if (!run_->recorder || Clock::now() < nextFlush_) return;
  nextFlush_ = Clock::now() + kFlushPeriod;
  run_->recorder->flush();
  if (const auto reason = run_->recorder->takeReason())
    announce(*reason, "The recording has ended, the flight goes on");
}

void WindowGame::saveScreenshot(const game::Snapshot& drawn) {
  screenshotWanted_ = false;
  try {
    const std::vector<core::PictureText> texts =
        pictureTexts(*run_, drawn, sceneRenderer_->view(drawn, window_.size()));
    notices_.add("Saved " + screenshots_.save(sceneRenderer_->renderer().readBack(), texts).string());
    faults_.clear(part::kScreenshot);
  } catch (const std::exception& refusal) {
    tell(part::kScreenshot, refusal.what());
    notices_.add(refusal.what());
  }
}

core::FrameStatistics WindowGame::statistics(std::size_t frames) {
  core::FrameStatistics statistics;
  times_.writeTo(statistics);
  simulation_->writeTo(statistics);
  sceneRenderer_->writeTo(statistics, frames);
  overlay_->writeTo(statistics);
  if (sound_) billRow(statistics, scene::nameOf(Effect::sound)).updateMs += soundCost_.meanMs();
  window_.writeTo(statistics);
  if (core::EffectStatistics* bill = statistics.billOf(scene::nameOf(Effect::sound)); bill && sound_)
    bill->idle = isPaused() || isFrozen() ? "time is held" : sound_->skipReason().value_or("");
  if (core::EffectStatistics* bill = statistics.billOf(scene::nameOf(Effect::hud)))
    bill->idle = overlay_->hudShown ? "" : "switched off (view.hud)";
  core::WindowStatistics& window = statistics.window;
  window.camera = render::cameraModeName(sceneRenderer_->camera().mode());
  window.menuOpen = overlay_->menuOpen;
  window.helpOpen = overlay_->helpOpen;
  window.escapeOpen = overlay_->escapeOpen;
  window.paused = isPaused();
  window.frozen = isFrozen();
  window.quality = kQualityNames[static_cast<std::size_t>(run_->quality)];
  window.fault = faults_.shown();
  window.costRows = costs_ ? static_cast<std::int64_t>(costs_->history.rows().size()) : -1;
  if (budget_) budget_->writeTo(window.budget);
  writeWeatherTo(window);
  window.splitShare = split_ ? split_->share() : -1;
  if (split_) split_->writeTo(statistics);
  window.loadedMs = loadedMs_;
  window.programsLoaded = programsLoaded_;
  window.screenshots = screenshots_.count();
  window.costs = {static_cast<std::int64_t>(shownStatistics_.passes.size()), shownStatistics_.frames,
                  shownStatistics_.gl.bytes};
  return statistics;
}

// Every step is tried, whatever became of the flight and of the steps before it.
void WindowGame::finish(std::exception_ptr failure) {
  const auto step = [&](const std::function<void()>& keep) {
    try {
      keep();
    } catch (...) {
      if (failure) {
        warn(reasonOf(std::current_exception()));
      } else {
        failure = std::current_exception();
      }
    }
  };
  step([&] {
    if (simulation_) simulation_->endRecording();
    if (!run_->recorder) return;
    if (const auto reason = run_->recorder->takeReason()) warn(*reason);
  });
  step([&] { keepChoices(); });
  step([&] {
    if (!sceneRenderer_) return;
    sceneRenderer_->renderer().finish();
    if (stats_) writeStatistics(*stats_, statistics());
  });
  if (failure) std::rethrow_exception(failure);
}

// What cannot be written is reported once and waits for the next time; the game goes on.
void WindowGame::keepChoices() {
  if (!run_->userFolder) return;
  bool kept = true;
  const auto keep = [&](const auto& save) {
    std::optional<std::string> line;
    try {
      line = save();
    } catch (const std::exception& refusal) {
      line = refusal.what();
    }
    if (!line) return;
    kept = false;
    tell(part::kChoices, *line);
  };
  keep([this] { return run_->userSettings.save(run_->playerTable, run_->bindings); });
  playerFile_.forget();
  keep([this] { return menuController_.save(overlay_->menu()); });
  keep([this] { return window_.remember(); });
  keep([this] { return best_.save(); });
  if (kept) faults_.clear(part::kChoices);
  lastGood_.userSettings = run_->userSettings;
}

}  // namespace skydrop::app
