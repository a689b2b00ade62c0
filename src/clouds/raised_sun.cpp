#include "skydrop/clouds/raised_sun.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "skydrop/core/shared.h"

namespace skydrop::clouds {

glm::dvec3 raisedSun(const glm::dvec3& toSun) {
  const double sine = core::shared::f64::kLeastSunSine;
  if (toSun.y >= sine) return toSun;
  const glm::dvec2 level(toSun.x, toSun.z);
  const double length = glm::length(level);
  const glm::dvec2 direction = length > 1e-9 ? level / length : glm::dvec2(1, 0);
  const glm::dvec2 scaled = direction * std::sqrt(1 - sine * sine);
  return {scaled.x, sine, scaled.y};
}

}  // namespace skydrop::clouds
