#include "render/clouds/sheet_view.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace skydrop::render {
namespace {

// The steepest ray is a corner of the picture, or the pole itself where that is in view. The horizontal edge
// is steeper in its middle than at its corners, so that counts too.
double steepestTowards(const View& view, const glm::dvec3& pole) {
  const glm::dvec3 inView = glm::inverse(rayMatrix(view)) * pole;
  if (inView.z > 0 && std::abs(inView.x) <= inView.z && std::abs(inView.y) <= inView.z) return 1;
  double steepest = -1;
  constexpr int kParts = 8;
  for (int i = 0; i <= kParts; ++i) {
    const double t = static_cast<double>(i) / kParts;
    for (const glm::dvec2& at : {glm::dvec2(t, 0), glm::dvec2(t, 1), glm::dvec2(0, t), glm::dvec2(1, t)}) {
      const glm::dvec3 ray = rayDirection(view, {at.x * view.width, at.y * view.height});
      steepest = std::max(steepest, glm::dot(ray, pole));
    }
  }
  // Between two of these places a ray is steeper by less than this.
  return std::min(steepest + 0.02, 1.0);
}

}  // namespace

double steepestUp(const View& view) { return steepestTowards(view, {0, 1, 0}); }
double steepestDown(const View& view) { return steepestTowards(view, {0, -1, 0}); }

bool missesLevelPlane(const View& view, double heightM, double radiusM) {
  const double rise = heightM - view.position.y;
  const double steepest = rise > 0 ? steepestUp(view) : steepestDown(view);
  // The corner of the plane is seen under the smallest angle.
  const double farthest = std::hypot(std::sqrt(2.0) * radiusM, rise);
  return steepest * farthest <= std::abs(rise);
}

}  // namespace skydrop::render
