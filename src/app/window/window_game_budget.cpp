// The frame budget in the window. Where none is set there is nothing of it.
#include <algorithm>
#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "app/console/message.h"
#include "app/session/noise_store.h"
#include "app/window/fault_parts.h"
#include "app/window/window_game.h"
#include "skydrop/core/joined.h"

namespace skydrop::app {
namespace {

using Milliseconds = std::chrono::duration<double, std::milli>;

// Passes that are drawn in the picture's own size, whatever a budget turns.
constexpr std::string_view kUngoverned[] = {"toneMap", "imgui", "split"};

}  // namespace

void WindowGame::renewBudget() {
  if (!sceneRenderer_) return;  // the player quit while loading
  if (run_->settings.view.frameBudgetMs <= 0) {
    if (!budget_) return;
    const SettingsChange change = govern(*run_, {});
    budget_.reset();
    changeNotDrawn_ = true;
    return apply(change);
  }
  BudgetFronts fronts = findBudgetFronts(
      BudgetFrontKey::of(run_->setup.scene, window_.context().renderer(), window_.size()), cacheFolder());
  if (!fronts.warning.empty()) warn(fronts.warning);
  // It judges rows as they are without it.
  SettingsChange change = govern(*run_, {});
  budget_ = std::make_unique<FrameBudget>(std::move(fronts), *run_);
  change.add(govern(*run_, budget_->rows()));
  budgetText_ = budget_->text();
  changeNotDrawn_ = true;
  apply(change);
  notices_.add(budgetText_, Notices::kUnrequestedSeconds);
}

// On a software renderer the frame is what the wall clock says, and drawing is what the rungs govern: there a
// swap waits for nothing but the picture. Elsewhere a swap may wait for the screen, and the passes' timers
// say what the graphics card does.
void WindowGame::followBudget(double drawnMs, double frameMs) {
  if (split_ || sceneRenderer_->isSwitching()) return budget_->forgetFrames();
  accuracy::BudgetFrame frame{frameMs,
                              Milliseconds(std::chrono::steady_clock::now() - drawingSince_).count()};
  if (!window_.context().isSoftware()) {
    double all = 0, governed = 0;
    for (const auto& [pass, ms] : sceneRenderer_->renderer().newestTimes()) {
      all += ms;
      if (std::ranges::find(kUngoverned, pass) == std::end(kUngoverned)) governed += ms;
    }
    frame = {std::max(all, drawnMs), governed};
  }
  const bool changed = budget_->note(frame);
  if (costs_ || changed) budgetText_ = budget_->text();
  if (!changed) return;
  attempt(part::kChange, [this] {
    const SettingsChange change = govern(*run_, budget_->rows());
    changeNotDrawn_ = true;
    apply(change);
  });
  if (budget_) notices_.add(budgetText_);
}

// A row that the player sets is theirs from then on, until the budget is set anew.
SettingsChange WindowGame::takeByHand(const SettingsChange& picked) {
  const std::vector<std::string> knobs = budget_ && !picked.touches("view.frameBudgetMs")
                                             ? budget_->knobsOf(picked)
                                             : std::vector<std::string>();
  if (knobs.empty()) return takeMenuChanges(*run_, picked);
  // They go back to what is beneath the budget, and then what was picked is put over that.
  GovernedRows rest = run_->governed, hand;
  std::erase_if(rest, [&](const auto& row) {
    return std::ranges::find(knobs, accuracy::knobOf(row.first)) != knobs.end();
  });
  for (const std::string& path : picked.paths()) hand.emplace_back(path, run_->table.at(path).get());
  SettingsChange change = govern(*run_, std::move(rest));
  for (const auto& [path, value] : hand) run_->table.at(path).set(value);
  change.add(takeMenuChanges(*run_, picked));
  budget_->letGo(knobs, *run_);
  change.add(govern(*run_, budget_->rows()));
  budgetText_ = budget_->text();
  notices_.add("The frame budget leaves to you: " + core::joined(knobs), Notices::kUnrequestedSeconds);
  return change;
}

}  // namespace skydrop::app
