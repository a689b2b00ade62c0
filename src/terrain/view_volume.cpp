#include "skydrop/terrain/view_volume.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace skydrop::terrain {

ViewVolume makeViewVolume(glm::dvec3 position, const glm::dmat3& worldToView, double fovYRad, int width,
                          int height) {
  const double up = std::tan(0.5 * fovYRad);
  const double right = up * width / height;
  const glm::dmat3 viewToWorld = glm::transpose(worldToView);
  ViewVolume view;
  view.position = position;
  view.inward = {glm::normalize(viewToWorld * glm::dvec3(1, 0, -right)),
                 glm::normalize(viewToWorld * glm::dvec3(-1, 0, -right)),
                 glm::normalize(viewToWorld * glm::dvec3(0, 1, -up)),
                 glm::normalize(viewToWorld * glm::dvec3(0, -1, -up))};
  view.edges = {viewToWorld * glm::dvec3(-right, -up, -1), viewToWorld * glm::dvec3(right, -up, -1),
                viewToWorld * glm::dvec3(right, up, -1), viewToWorld * glm::dvec3(-right, up, -1)};
  view.pixelsPerRadian = 0.5 * height / up;
  return view;
}

namespace {

bool mayBeInside(const ViewVolume& view, const Box& box) {
  const glm::dvec3 lo = box.lo - view.position, hi = box.hi - view.position;
  for (const glm::dvec3& n : view.inward) {
    const double deepest =
        (n.x > 0 ? hi.x : lo.x) * n.x + (n.y > 0 ? hi.y : lo.y) * n.y + (n.z > 0 ? hi.z : lo.z) * n.z;
    if (deepest < 0) return false;
  }
  // Along a box axis the pyramid reaches from the eye to infinity on the sides its edges point to.
  for (int axis = 0; axis < 3; ++axis) {
    if (hi[axis] < 0 &&
        std::all_of(view.edges.begin(), view.edges.end(), [&](const auto& e) { return e[axis] >= 0; }))
      return false;
    if (lo[axis] > 0 &&
        std::all_of(view.edges.begin(), view.edges.end(), [&](const auto& e) { return e[axis] <= 0; }))
      return false;
  }
  return true;
}

}  // namespace

bool mayBeVisible(const ViewVolume& view, const Box& box) {
  return mayBeInside(view, box) ||
         std::any_of(view.beside.begin(), view.beside.end(),
                     [&](const ViewVolume& other) { return mayBeInside(other, box); });
}

double nearestDistance(const ViewVolume& view, const Box& box) {
  return glm::distance(view.position, glm::clamp(view.position, box.lo, box.hi));
}

double nearestGroundDistance(const ViewVolume& view, const Box& box) {
  const double x = view.position.x - std::clamp(view.position.x, box.lo.x, box.hi.x);
  const double z = view.position.z - std::clamp(view.position.z, box.lo.z, box.hi.z);
  return std::sqrt(x * x + z * z);
}

}  // namespace skydrop::terrain
