#include "app/session/frame_budget.h"

#include <algorithm>
#include <set>
#include <utility>

#include "app/settings/cloud_tier.h"

namespace skydrop::app {
namespace {

std::string pathOf(const std::string& assignment) { return assignment.substr(0, assignment.find('=')); }

// The paths that the points of the fronts turn.
std::set<std::string> turnedPaths(const accuracy::Results& results) {
  std::set<std::string> paths;
  for (const accuracy::CaseResult& of : results.cases) {
    for (const accuracy::PointResult& point : of.points) {
      for (const std::string& one : point.set) paths.insert(pathOf(one));
    }
  }
  return paths;
}

}  // namespace

FrameBudget::FrameBudget(BudgetFronts fronts, const RunConfig& run)
    : fronts_(std::move(fronts)), budgetMs_(run.settings.view.frameBudgetMs) {
  std::set<std::string> knobs;
  for (const core::Field& field : run.table.fields()) {
    if (!mayGovern(field)) continue;
    const bool isSet = std::ranges::any_of(run.overrides, [&](const std::string& one) {
      const core::Field* set = run.table.find(pathOf(one));
      return set && set->path == field.path;
    });
    if (isSet) knobs.insert(std::string(accuracy::knobOf(field.path)));
  }
  const bool hasClouds = effectsOf(run).contains(scene::Effect::clouds);
  if (!hasClouds || run.settings.clouds.tier == clouds::CloudTier::off)
    knobs.insert(std::string(accuracy::knobOf(kCloudTierRow)));
  for (const std::string& knob : knobs) hold(knob, run);
  begin();
}

void FrameBudget::hold(std::string knob, const RunConfig& run) {
  for (const std::string& path : turnedPaths(fronts_.results)) {
    // Of a tier only its name is compared: its rows go with it.
    if (accuracy::knobOf(path) != knob || belongsToCloudTier(path)) continue;
    held_.push_back(path + "=" + core::fieldText(run.table.at(path)));
  }
  heldKnobs_.push_back(std::move(knob));
}

void FrameBudget::begin() {
  std::vector<accuracy::BudgetRung> ladder = accuracy::budgetLadder(fronts_.results, held_);
  const bool turns = !ladder.empty() && !ladder.front().set.empty();
  controller_ = turns ? std::make_unique<accuracy::BudgetController>(std::move(ladder), budgetMs_) : nullptr;
  takeRows();
}

void FrameBudget::takeRows() {
  rows_ = controller_ ? governedRows(controller_->chosen().set, fronts_.file) : GovernedRows();
}

bool FrameBudget::note(const accuracy::BudgetFrame& frame) {
  if (!controller_ || !controller_->note(frame)) return false;
  takeRows();
  return true;
}

void FrameBudget::forgetFrames() {
  if (controller_) controller_->forgetFrames();
}

std::vector<std::string> FrameBudget::knobsOf(const SettingsChange& rows) const {
  std::vector<std::string> knobs;
  for (const auto& [path, value] : rows_) {
    const std::string knob(accuracy::knobOf(path));
    if (rows.touches(path) && std::ranges::find(knobs, knob) == knobs.end()) knobs.push_back(knob);
  }
  return knobs;
}

void FrameBudget::letGo(const std::vector<std::string>& knobs, const RunConfig& run) {
  for (const std::string& knob : knobs) hold(knob, run);
  if (controller_) changesBefore_ += controller_->changes();
  begin();
}

std::string FrameBudget::text() const {
  if (!controller_) return "Frame budget: all that it could turn is set by hand, or not there.";
  return "Frame budget: " + controller_->reason() + " (" + fronts_.source + ")";
}

void FrameBudget::writeTo(core::BudgetStatistics& statistics) const {
  statistics.budgetMs = budgetMs_;
  statistics.text = text();
  statistics.measured = fronts_.measured;
  statistics.changes = changesBefore_;
  if (!controller_) return;
  statistics.medianMs = controller_->medianMs();
  statistics.choice = controller_->chosen().label;
  statistics.rung = static_cast<std::int64_t>(controller_->rung());
  statistics.rungs = static_cast<std::int64_t>(controller_->ladder().size());
  statistics.holds = controller_->holds();
  statistics.changes += controller_->changes();
}

}  // namespace skydrop::app
