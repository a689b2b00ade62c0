#include "skydrop/game/lesson.h"

#include <cmath>

#include "skydrop/core/deterministic_math.h"

namespace skydrop::game {

Lesson::Step Lesson::update(const Snapshot& now) {
  const AircraftSnapshot& craft = now.aircraft;
  if (!craft.present || craft.crashed) return step_;
  switch (step_) {
    case Step::turn: {
      if (!now.target.present) break;
      const double off = std::remainder(now.target.bearingRad - craft.headingRad, core::dmath::kTwoPi);
      if (std::abs(off) < kAheadRad && std::abs(craft.bankRad) < kLevelRad) {
        step_ = Step::height;
        heightM_ = craft.position.y;
      }
      break;
    }
    case Step::height:
      if (std::abs(craft.position.y - *heightM_) > kHeightM) {
        step_ = Step::drop;
        score_ = now.score;
      }
      break;
    case Step::drop:
      if (now.score > *score_) step_ = Step::done;
      break;
    case Step::done:
      break;
  }
  return step_;
}

}  // namespace skydrop::game
