// The panel of costs in the window. While it is closed nothing of it exists.
#include <algorithm>

#include "app/window/window_game.h"

namespace skydrop::app {
namespace {

constexpr std::size_t kShownFrames = 240;

}  // namespace

void WindowGame::toggleCosts() {
  if (costs_) return costs_.reset();
  costs_ = std::make_unique<OpenCosts>();
  costs_->fronts = readMeasuredFronts(measuredFrontsFolder());
  costs_->knobs = knobStands(costs_->fronts.results, run_->table);
}

// Passes by the renderer's clock, everything else by the main thread's CPU time.
void WindowGame::noteCosts() {
  if (!costs_) return;
  using Kind = ui::CostKind;
  CostHistory& history = costs_->history;
  for (const auto& [name, ms] : sceneRenderer_->renderer().newestTimes()) history.add(Kind::pass, name, ms);
  const game::StepCosts steps = simulation_->costs();
  history.addTotal(Kind::simulation, "aircraft", steps.aircraftMs);
  history.addTotal(Kind::simulation, "targets", steps.targetsMs);
  history.addTotal(Kind::simulation, "world",
                   std::max(0.0, simulation_->costMs() - steps.aircraftMs - steps.targetsMs));
  history.addTotal(Kind::update, "land", sceneRenderer_->streamingMs());
  history.addTotal(Kind::update, "sound", soundCost_.ms());
  history.addTotal(Kind::update, "interface", overlay_->costMs());
  history.endFrame();
  costs_->clock = sceneRenderer_->renderer().clockName();
}

ui::CostPanelContent WindowGame::costContent() const {
  return {.rows = costs_->history.rows(),
          .frameMs = times_.newest(kShownFrames),
          .clock = costs_->clock,
          .knobs = costs_->knobs,
          .note = costs_->fronts.note,
          .budget = budget_ ? std::string_view(budgetText_) : std::string_view()};
}

}  // namespace skydrop::app
