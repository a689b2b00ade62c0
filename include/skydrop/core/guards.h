// Named guards against numerical degeneracy. What may happen now and then (no airspeed, a sine rounded past
// 1, a stick that sends NaN) is handled where it happens and counted here, so that "rare" can be checked:
// the counts are shown in the statistics. Thread-safe; counting is one relaxed atomic increment. There is one
// set of counters for the whole process, since it started: two worlds in one program count together, and
// whoever wants the counts of one run takes differences or resets them before it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string_view>

namespace skydrop::core {

enum class Guard {
  arcSineDomain,     // |sine| rounded past 1, clamped
  squareRootDomain,  // a square rounded below 0, clamped
  zeroDirection,     // the direction of a vector too short to have one, replaced by a stated fallback
  notFiniteControl,  // a stick axis that was NaN or infinite, read as 0
  notFiniteForce,    // a force or torque that was not finite, ignored
  notFiniteState,    // a step that would have left the body's state not finite, refused
  stiffStep,         // a step of a body too stiff for its integrator, divided
  clockStep,         // a frame time that was NaN or infinite, ignored
  targetWidened,     // no land for a target within the wanted distance, searched further out
  stepsDropped,      // steps of a frame that took longer than may be caught up, left out
  jobRetried,        // a job that threw, tried again
  jobFailed,         // a job that threw each time, given up
  respawnRaised,     // the last safe place had higher ground ahead, respawned above it
  count_
};

using GuardCounts = std::array<std::uint64_t, static_cast<std::size_t>(Guard::count_)>;  // by Guard

void countGuard(Guard guard, std::uint64_t times = 1);
std::uint64_t guardCount(Guard guard);
GuardCounts guardCounts();
std::string_view guardName(Guard guard);
void resetGuardCounts();

// asin with its argument clamped to [-1, 1]; counted where it was more than rounding (1e-9) outside. NaN
// stays NaN.
double safeAsin(double sine);

// sqrt of max(x, 0); counted where x < -1e-9.
double safeSqrt(double x);

// v / |v|, or `fallback` (a unit vector) where |v| < 1e-150 or v is not finite; counted then.
glm::dvec3 safeNormalize(const glm::dvec3& v, const glm::dvec3& fallback);

bool isFinite(const glm::dvec3& v);

}  // namespace skydrop::core
