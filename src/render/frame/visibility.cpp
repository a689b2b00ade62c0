#include "render/frame/visibility.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace skydrop::render {

bool isPotentiallyVisible(const View& view, const glm::dvec3& middle, double radiusM) {
  const glm::dvec3 seen = view.worldToView * (middle - view.position);
  if (glm::length(seen) <= radiusM) return true;
  const double ahead = -seen.z;
  if (ahead < -radiusM) return false;
  const double tanY = std::tan(view.fovYRad / 2), tanX = tanY * view.aspect();
  // Distance to the plane through the eye and an edge of the picture, whose tangent it has.
  const auto liesBeyond = [&](double aside, double tangent) {
    return (aside - ahead * tangent) / std::sqrt(1 + tangent * tangent) > radiusM;
  };
  const glm::dvec2 axis = view.offAxis;
  if (liesBeyond(seen.x, tanX + axis.x) || liesBeyond(-seen.x, tanX - axis.x)) return false;
  if (liesBeyond(seen.y, tanY + axis.y) || liesBeyond(-seen.y, tanY - axis.y)) return false;
  const double pixels = radiusM / glm::length(seen) / view.pixelAngleRad();
  return pixels > 1.0 / 6;
}

bool isPotentiallyVisible(const View& view, const std::array<glm::dvec3, 8>& corners) {
  const double tangentY = std::tan(view.fovYRad / 2), tangentX = tangentY * view.aspect();
  std::array<std::size_t, 5> beyond{};
  for (const glm::dvec3& corner : corners) {
    const glm::dvec3 seen = view.worldToView * corner;
    const double ahead = -seen.z;
    beyond[0] += ahead < view.nearM;
    beyond[1] += seen.x > ahead * (tangentX + view.offAxis.x);
    beyond[2] += -seen.x > ahead * (tangentX - view.offAxis.x);
    beyond[3] += seen.y > ahead * (tangentY + view.offAxis.y);
    beyond[4] += -seen.y > ahead * (tangentY - view.offAxis.y);
  }
  return std::none_of(beyond.begin(), beyond.end(), [&](std::size_t n) { return n == corners.size(); });
}

double leastRise(const View& view) {
  double least = 1;
  for (const double x : {0, view.width}) {
    for (const double y : {0, view.height}) least = std::min(least, rayDirection(view, {x, y}).y);
  }
  return least;
}

PixelBox pixelsOf(const View& view, const glm::mat4& toEye, const glm::dvec3& low, const glm::dvec3& high) {
  const PixelBox all{0, 0, view.width, view.height};
  const double scale = 1 / view.pixelAngleRad();
  glm::dvec2 first(1e300), last(-1e300);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 place(corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y,
                           corner & 4 ? high.z : low.z);
    const glm::dvec3 seen = view.worldToView * (glm::dmat3(glm::dmat4(toEye)) * place + glm::dvec3(toEye[3]));
    if (-seen.z < view.nearM) return all;
    const glm::dvec2 pixel =
        (glm::dvec2(seen) / -seen.z - view.offAxis) * scale + 0.5 * glm::dvec2(view.width, view.height);
    first = glm::min(first, pixel);
    last = glm::max(last, pixel);
  }
  const auto within = [](double pixel, int size) {
    return static_cast<int>(std::clamp<double>(pixel, 0, size));
  };
  return {within(std::floor(first.x), view.width), within(std::floor(first.y), view.height),
          within(std::ceil(last.x), view.width), within(std::ceil(last.y), view.height)};
}

}  // namespace skydrop::render
