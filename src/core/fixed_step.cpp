#include "skydrop/core/fixed_step.h"

#include <algorithm>
#include <cmath>

#include "skydrop/core/guards.h"

namespace skydrop::core {

int FixedStep::advance(double realSeconds) {
  if (!std::isfinite(realSeconds)) {
    countGuard(Guard::clockStep);
    return 0;
  }
  if (realSeconds <= 0) return 0;
  // The started step from the frame before counts towards the bound: 30 steps are the most a frame does.
  const double due = std::min(pending_ + realSeconds * kStepsPerSecond, kMaxCatchUpSeconds * kStepsPerSecond);
  const double whole = std::floor(due);
  pending_ = due - whole;
  steps_ += static_cast<std::uint64_t>(whole);
  return static_cast<int>(whole);
}

}  // namespace skydrop::core
