#include "render/clouds/sheet_sun.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace skydrop::render {

glm::dvec3 sunOnSheet(const SkyLight& light, double heightM) {
  constexpr double kEarthRadiusM = 6.371e6;
  sky::SkyLight there = light;
  // The dip matters where the sun is low alone; a high sun is left where it is.
  const double dip = std::sqrt(2 * std::max(heightM, 0.0) / kEarthRadiusM);
  there.toSun = glm::normalize(light.toSun + glm::dvec3(0, dip * (1 - std::abs(light.toSun.y)), 0));
  return sky::sunIlluminance(there, heightM) * light.exposure;
}

}  // namespace skydrop::render
