// The split view in the window: begun and ended by a key, and begun again when what it compares changes.
#include <exception>
#include <string>

#include "app/console/message.h"
#include "app/window/fault_parts.h"
#include "app/window/split_texts.h"
#include "app/window/window_game.h"
#include "skydrop/core/error.h"

namespace skydrop::app {
namespace {

constexpr double kBudgetMs = 30;  // of a frame, for parts of the reference; the last part comes on top

bool isOnlyOfTheSplitView(const SettingsChange& change) {
  for (const std::string& path : change.paths()) {
    if (path != "view.split.divider" && path != "view.split.heat") return false;
  }
  return true;
}

}  // namespace

void WindowGame::toggleSplit() {
  if (split_) return endSplit();
  if (sceneRenderer_->isSwitching()) return notices_.add("The split view waits until the effects are there");
  if (!isFrozen()) {
    toggle("view.freezeTime");
    splitFroze_ = true;
  }
  beginSplit();
}

// Of the settings as they are now.
void WindowGame::beginSplit() {
  split_.reset();
  try {
    SplitReference reference =
        splitReference(run_->settings, simulation_->effects(), run_->settings.view.split.subject);
    split_ = std::make_unique<SplitView>(*sceneRenderer_, run_->settings, std::move(reference));
  } catch (const std::exception& refusal) {
    notices_.add("No split view: " + std::string(refusal.what()), Notices::kUnrequestedSeconds);
  }
}

// Time goes on in the next frame if it was held for this.
void WindowGame::endSplit() { split_.reset(); }

// After a change was taken over by whoever draws.
void WindowGame::followSplit(const SettingsChange& change) {
  if (!split_) return;
  split_->setDivider(run_->settings.view.split.divider);
  split_->setHeat(run_->settings.view.split.heat);
  if (isOnlyOfTheSplitView(change)) return;
  if (!isFrozen()) {
    splitFroze_ = false;
    return endSplit();
  }
  beginSplit();
}

void WindowGame::releaseFreeze() {
  if (split_ || !std::exchange(splitFroze_, false) || !isFrozen()) return;
  toggle("view.freezeTime");
}

void WindowGame::drawSplit(const game::Snapshot& snapshot, Size size) {
  if (split_) {
    split_->draw(snapshot, size, kBudgetMs);
  } else {
    sceneRenderer_->draw(snapshot, size, Streaming::asItComes);
  }
}

void WindowGame::dragDivider(double divider) {
  core::setField(run_->table.at("view.split.divider"), divider);
  attempt(part::kChange, [&] { applyMenuChanges({"view.split.divider"}); });
}

}  // namespace skydrop::app
