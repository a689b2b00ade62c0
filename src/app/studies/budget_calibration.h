// Measures what a frame budget chooses from (assets/budget/study.json) for one scene and size on this
// machine: errors in small pictures, because their reference takes seconds a frame, and times in the
// picture's own size. Main thread.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "app/session/budget_fronts.h"
#include "app/types/size.h"
#include "skydrop/accuracy/result.h"
#include "skydrop/accuracy/study.h"

namespace skydrop::app {

// The study of what a budget may turn. Throws core::DataError.
accuracy::Study budgetStudy();

struct Calibration {
  std::string scene;               // that the cases look at, a name or a file
  BudgetFrontKey key;              // of the results
  accuracy::Assignments set = {};  // beneath all points: the quality of this machine
  Size errorSize{160, 90};
  int repeats = 3;  // of times; a point that takes longer than kLongMs is timed once
  static constexpr double kLongMs = 400;
};

// `tell` is called after each part: parts done, of all. Throws core::DataError, core::GraphicsUnavailable.
accuracy::Results calibrated(const accuracy::Study& study, const Calibration& calibration,
                             const std::function<void(std::size_t done, std::size_t all)>& tell = {});

}  // namespace skydrop::app
