#include "skydrop/accuracy/budget_controller.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <span>
#include <utility>

#include "skydrop/core/quantile.h"

namespace skydrop::accuracy {
namespace {

constexpr double kMostExcess = 4;

std::string text(const char* format, auto... values) {
  std::array<char, 96> buffer{};
  std::snprintf(buffer.data(), buffer.size(), format, values...);
  return buffer.data();
}

void keepNewest(std::vector<double>& of, double value, std::size_t most) {
  if (of.size() >= most) of.erase(of.begin());
  of.push_back(value);
}

}  // namespace

BudgetController::BudgetController(std::vector<BudgetRung> ladder, double budgetMs, const BudgetRules& rules)
    : ladder_(std::move(ladder)), budgetMs_(budgetMs), rules_(rules), trials_(ladder_.size()) {
  assert(!ladder_.empty() && budgetMs > 0);
  while (rung_ + 1 < ladder_.size() && ladder_[rung_ + 1].ms <= budgetMs_) ++rung_;
}

double BudgetController::median(std::vector<double> of, std::size_t newest) const {
  return core::quantileOf(std::span(of).last(std::min(newest, of.size())), 0.5);
}

double BudgetController::medianMs() const { return median(frameMs_, rules_.window); }

double BudgetController::predictedMs(std::size_t rung) const {
  if (frameMs_.empty()) return ladder_[rung].ms;
  const double present = medianMs(), rest = std::min(median(restMs_, rules_.window), present);
  const Trial& trial = trials_[rung];
  const bool isKnown = rung > rung_ && seconds_ < trial.blockedUntil;
  return rest + (present - rest) * ladder_[rung].ms / ladder_[rung_].ms * (isKnown ? trial.excess : 1.0);
}

bool BudgetController::exceeds() const {
  if (frameMs_.size() < rules_.fewestFrames) return false;
  if (median(frameMs_, rules_.shortWindow) > rules_.overShare * budgetMs_) return true;
  return frameMs_.size() >= rules_.window && medianMs() > budgetMs_;
}

// Where it came from, if what was gone up to has failed; else the most exact one below that should fit, or
// the cheapest.
std::size_t BudgetController::lower() const {
  if (isOnTrial()) return cameFrom_;
  std::size_t rung = rung_ - 1;
  while (rung > 0 && predictedMs(rung) > budgetMs_) --rung;
  return rung;
}

// The most exact one above that fits with its margin and is not blocked; else the present one.
std::size_t BudgetController::higher() const {
  std::size_t best = rung_;
  for (std::size_t rung = rung_ + 1; rung < ladder_.size(); ++rung) {
    if (seconds_ < trials_[rung].blockedUntil) break;
    const double margin = rules_.upMargin + rules_.marginPerRung * static_cast<double>(rung - rung_ - 1);
    if (predictedMs(rung) > budgetMs_ * (1 - margin)) break;
    best = rung;
  }
  return best;
}

bool BudgetController::isOnTrial() const { return wentUp_ && seconds_ - movedAt_ <= rules_.provenSeconds; }

void BudgetController::noteFailure() {
  if (!isOnTrial()) return;
  Trial& trial = trials_[rung_];
  const double wait = std::ldexp(rules_.firstBackOffSeconds, std::min(trial.failures, 30));
  trial.blockedUntil = seconds_ + std::min(wait, rules_.mostBackOffSeconds);
  ++trial.failures;
  const double took = median(frameMs_, rules_.shortWindow);
  trial.excess = std::clamp(took / expectedMs_, 1.0, kMostExcess);
}

void BudgetController::moveTo(std::size_t rung) {
  if (rung > rung_) expectedMs_ = predictedMs(rung);
  wentUp_ = rung > rung_;
  cameFrom_ = rung_;
  rung_ = rung;
  ++changes_;
  movedAt_ = seconds_;
  forgetFrames();
}

void BudgetController::forgetFrames() {
  frameMs_.clear();
  restMs_.clear();
  settling_ = rules_.settleFrames;
  fitsSince_ = -1;
}

bool BudgetController::note(const BudgetFrame& frame) {
  if (!std::isfinite(frame.ms) || frame.ms < kLeastMs || frame.ms > kMostMs) return false;
  const bool isPart = frame.governedMs >= 0 && frame.governedMs <= frame.ms;  // false for NaN
  seconds_ += frame.ms / 1000;
  if (settling_ > 0) {
    --settling_;
    return false;
  }
  keepNewest(frameMs_, frame.ms, rules_.window);
  keepNewest(restMs_, isPart ? frame.ms - frame.governedMs : 0.0, rules_.window);
  if (wentUp_ && !isOnTrial()) {
    wentUp_ = false;
    trials_[rung_] = {};
  }
  if (exceeds()) {
    fitsSince_ = -1;
    if (rung_ == 0) return false;
    const std::size_t next = lower();
    noteFailure();
    moveTo(next);
    return true;
  }
  const std::size_t next = frameMs_.size() < rules_.window ? rung_ : higher();
  if (next == rung_) {
    fitsSince_ = -1;
    return false;
  }
  if (fitsSince_ < 0) fitsSince_ = seconds_;
  if (seconds_ - fitsSince_ < rules_.upSeconds) return false;
  moveTo(next);
  return true;
}

bool BudgetController::holds() const {
  return rung_ > 0 || frameMs_.size() < rules_.fewestFrames || medianMs() <= budgetMs_;
}

std::string BudgetController::reason() const {
  std::string line = frameMs_.empty() ? text("budget %.3g ms: ", budgetMs_)
                                      : text("%.1f of %.3g ms: ", medianMs(), budgetMs_);
  line += chosen().label;
  if (!holds()) return line + ", the cheapest, does not fit; nothing is left to turn";
  if (rung_ + 1 == ladder_.size()) return line + ", the best that was measured";
  const BudgetRung& next = ladder_[rung_ + 1];
  return line + "; the next better, " + next.label + text(", would need %.0f ms", predictedMs(rung_ + 1));
}

}  // namespace skydrop::accuracy
