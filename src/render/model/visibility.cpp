#include "render/model/visibility.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace skydrop::render {

bool maySee(const View& view, const glm::dvec3& middle, double radiusM) {
  const glm::dvec3 seen = view.worldToView * (middle - view.position);
  if (glm::length(seen) <= radiusM) return true;
  const double ahead = -seen.z;
  if (ahead < -radiusM) return false;
  const double tanY = std::tan(view.fovYRad / 2), tanX = tanY * view.aspect();
  // Distance to the plane through the eye and the picture's edge.
  if ((std::abs(seen.x) - ahead * tanX) / std::sqrt(1 + tanX * tanX) > radiusM) return false;
  if ((std::abs(seen.y) - ahead * tanY) / std::sqrt(1 + tanY * tanY) > radiusM) return false;
  const double pixels = radiusM / glm::length(seen) / (2 * tanY) * view.height;
  return pixels > 1.0 / 6;
}

}  // namespace skydrop::render
