#include "skydrop/accuracy/observation.h"

#include <algorithm>
#include <cmath>

#include "skydrop/core/guards.h"

namespace skydrop::accuracy {

std::string notFiniteAt(const Observation& o) {
  const auto bad = [](double value) { return !std::isfinite(value); };
  if (const auto found = std::ranges::find_if(o.values, bad); found != o.values.end()) {
    const auto index = found - o.values.begin();
    if (!o.isPicture()) return "value " + std::to_string(index) + " is not finite";
    const auto pixel = index / 3;
    return "the value of pixel (" + std::to_string(pixel % o.width) + ", " + std::to_string(pixel / o.width) +
           ") is not finite";
  }
  const auto badVector = [](const glm::dvec3& v) { return !core::isFinite(v); };
  const auto badAttitude = [&](const glm::dquat& q) { return bad(q.w) || bad(q.x) || bad(q.y) || bad(q.z); };
  if (std::ranges::any_of(o.positions, badVector)) return "a position is not finite";
  if (std::ranges::any_of(o.directions, badVector)) return "a direction is not finite";
  if (std::ranges::any_of(o.attitudes, badAttitude)) return "an attitude is not finite";
  if (std::ranges::any_of(o.energies, bad)) return "an energy is not finite";
  return {};
}

}  // namespace skydrop::accuracy
