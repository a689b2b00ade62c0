#include "skydrop/core/guards.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

#include "skydrop/core/deterministic_math.h"

namespace skydrop::core {
namespace {

constexpr std::size_t kGuards = static_cast<std::size_t>(Guard::count_);

std::array<std::atomic<std::uint64_t>, kGuards>& counters() {
  static std::array<std::atomic<std::uint64_t>, kGuards> all{};
  return all;
}

constexpr double kRounding =
    1e-9;  // what a chain of double operations on unit vectors can be off by, and more

}  // namespace

void countGuard(Guard guard, std::uint64_t times) {
  counters()[static_cast<std::size_t>(guard)].fetch_add(times, std::memory_order_relaxed);
}

std::uint64_t guardCount(Guard guard) {
  return counters()[static_cast<std::size_t>(guard)].load(std::memory_order_relaxed);
}

GuardCounts guardCounts() {
  GuardCounts counts;
  for (std::size_t i = 0; i < counts.size(); ++i) counts[i] = guardCount(static_cast<Guard>(i));
  return counts;
}

std::string_view guardName(Guard guard) {
  switch (guard) {
    case Guard::arcSineDomain:
      return "arcSineDomain";
    case Guard::squareRootDomain:
      return "squareRootDomain";
    case Guard::zeroDirection:
      return "zeroDirection";
    case Guard::notFiniteControl:
      return "notFiniteControl";
    case Guard::notFiniteForce:
      return "notFiniteForce";
    case Guard::notFiniteState:
      return "notFiniteState";
    case Guard::stiffStep:
      return "stiffStep";
    case Guard::clockStep:
      return "clockStep";
    case Guard::targetWidened:
      return "targetWidened";
    case Guard::stepsDropped:
      return "stepsDropped";
    case Guard::jobRetried:
      return "jobRetried";
    case Guard::jobFailed:
      return "jobFailed";
    case Guard::respawnRaised:
      return "respawnRaised";
    case Guard::count_:
      break;
  }
  return "unknown";
}

void resetGuardCounts() {
  for (auto& counter : counters()) counter.store(0, std::memory_order_relaxed);
}

double safeAsin(double sine) {
  if (std::abs(sine) > 1 + kRounding) countGuard(Guard::arcSineDomain);
  return dmath::asin(std::clamp(sine, -1.0, 1.0));
}

double safeSqrt(double x) {
  if (x < -kRounding) countGuard(Guard::squareRootDomain);
  return std::sqrt(x < 0 ? 0 : x);
}

glm::dvec3 safeNormalize(const glm::dvec3& v, const glm::dvec3& fallback) {
  // Scaling by the largest component first: squares neither overflow nor vanish.
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!isFinite(v) || largest < 1e-150) {
    countGuard(Guard::zeroDirection);
    return fallback;
  }
  const glm::dvec3 scaled = v / largest;
  return scaled / std::sqrt(glm::dot(scaled, scaled));
}

bool isFinite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace skydrop::core
