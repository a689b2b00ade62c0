// Angles as turns to make.
#pragma once

#include "skydrop/core/deterministic_math.h"

namespace skydrop::game {

// To (-pi, pi]; of angles within some turns.
inline double wrappedAngle(double angleRad) {
  while (angleRad > core::dmath::kPi) angleRad -= core::dmath::kTwoPi;
  while (angleRad <= -core::dmath::kPi) angleRad += core::dmath::kTwoPi;
  return angleRad;
}

}  // namespace skydrop::game
