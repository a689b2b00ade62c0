// The stick by which a pilot of ours brings the aircraft to an attitude and holds it there: feedback on what
// is missing and on the rate, and what the stabiliser takes away.
#pragma once

#include <algorithm>
#include <cmath>

#include "skydrop/core/deterministic_math.h"
#include "skydrop/game/snapshot.h"

namespace skydrop::game {

// Roll for a bank (rad, right wing down positive), in [-1, 1].
inline double rollTo(const AircraftSnapshot& craft, double bankRad) {
  return std::clamp(
      0.67 * core::dmath::sin(bankRad) + 2.5 * (bankRad - craft.bankRad) + 0.3 * craft.angularVelocityBody.z,
      -1.0, 1.0);
}

// Pitch for an angle of the flight path (rad, up positive); not limited to what a stick can do. `gain`: full
// deflections a radian that is missing.
inline double pitchTo(const AircraftSnapshot& craft, double climbRad, double gain) {
  const glm::dvec3& v = craft.velocity;
  const double path = core::dmath::atan2(v.y, std::sqrt(v.x * v.x + v.z * v.z));
  return 0.65 * core::dmath::sin(climbRad) + gain * (climbRad - path) - 0.8 * craft.angularVelocityBody.x;
}

}  // namespace skydrop::game
