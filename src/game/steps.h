// Seconds and steps of 1/120 s.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "skydrop/core/fixed_step.h"

namespace skydrop::game {

// The nearest whole number of steps; none for a negative time.
inline std::uint64_t stepsOf(double seconds) {
  return static_cast<std::uint64_t>(
      std::floor(std::max(seconds, 0.0) * core::FixedStep::kStepsPerSecond + 0.5));
}

inline double secondsOf(std::uint64_t steps) { return core::FixedStep::secondsOf(steps); }

}  // namespace skydrop::game
