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
  constexpr double kMost = kMaxCatchUpSeconds * kStepsPerSecond;
  const double wanted = pending_ + realSeconds * kStepsPerSecond, due = std::min(wanted, kMost);
  if (wanted >= kMost + 1)
    countGuard(Guard::stepsDropped, static_cast<std::uint64_t>(std::min(wanted - kMost, 1e9)));
  const double whole = std::floor(due);
  pending_ = due - whole;
  steps_ += static_cast<std::uint64_t>(whole);
  return static_cast<int>(whole);
}

}  // namespace skydrop::core
