// A frame budget in force: what it may turn in this run, the controller that chooses, and the rows that its
// choice comes to. Exists only while a budget is set. Main thread.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/session/budget_fronts.h"
#include "app/session/run_config.h"
#include "app/settings/settings_change.h"
#include "skydrop/accuracy/budget_controller.h"
#include "skydrop/core/frame_statistics.h"

namespace skydrop::app {

class FrameBudget {
 public:
  // Of run.settings.view.frameBudgetMs, which is above 0. Rows that --set has set stay as they are; clouds
  // that the scene lacks, or whose tier is off, are not turned. Throws core::DataError.
  FrameBudget(BudgetFronts fronts, const RunConfig& run);

  // Of the frame that was drawn last. True: rows() changed.
  bool note(const accuracy::BudgetFrame& frame);
  // What was measured says nothing of the frames to come.
  void forgetFrames();
  // The knobs whose rows are in force and among these: rows that were measured together are one ("clouds",
  // "render").
  std::vector<std::string> knobsOf(const SettingsChange& rows) const;
  // Gives these up, from now on: they are as they are in the run. rows() changes.
  void letGo(const std::vector<std::string>& knobs, const RunConfig& run);

  // In force; empty where nothing is left to turn.
  const GovernedRows& rows() const { return rows_; }
  const BudgetFronts& fronts() const { return fronts_; }

  // "32.4 of 33 ms: ...": what was chosen, why, and by which fronts.
  std::string text() const;
  void writeTo(core::BudgetStatistics& statistics) const;

 private:
  void hold(std::string knob, const RunConfig& run);
  void begin();
  void takeRows();

  BudgetFronts fronts_;
  double budgetMs_;
  std::vector<std::string> heldKnobs_;
  accuracy::Assignments held_;                              // rows of those, as they are
  std::unique_ptr<accuracy::BudgetController> controller_;  // null: nothing is left to turn
  GovernedRows rows_;
  std::int64_t changesBefore_ = 0;  // of controllers that were replaced
};

}  // namespace skydrop::app
