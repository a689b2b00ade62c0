// What a frame budget may choose from: settings that were measured together, from the cheapest to the most
// exact. Made of results (result.h) whose points set the same paths at every case. A value; any thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "skydrop/accuracy/result.h"
#include "skydrop/accuracy/study.h"

namespace skydrop::accuracy {

struct BudgetRung {
  std::string label;  // "scale 0.5, clouds low"
  double ms = 0;      // > 0: mean over the cases of their medians
  double error = 0;   // >= 0: root mean square over the cases, of their first metric
  Assignments set;
};

// The group of a path that is given up as a whole: what stands before its first dot.
std::string_view knobOf(std::string_view path);

// The front of error over time over all cases, by growing time and falling error. Of points whose times are
// closer than kLeastStep the most exact is kept: a step must be worth a change. Points that were not measured
// in every case are left out; empty where there are none, or no case.
//
// `held`: what others decide, as assignments. Their knobs are taken out: of the points those are used that
// agree with all of `held` of that knob, or, where none does, that have it as the last point has.
inline constexpr double kLeastStep = 1.08;
std::vector<BudgetRung> budgetLadder(const Results& results, const Assignments& held = {});

}  // namespace skydrop::accuracy
