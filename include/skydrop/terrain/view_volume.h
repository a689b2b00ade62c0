// What the eye sees, for culling and for the choice of detail. No GL, no matrices to invert.
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "skydrop/terrain/height_source.h"

namespace skydrop::terrain {

// An axis-aligned box, world metres, lo <= hi.
struct Box {
  glm::dvec3 lo{0.0}, hi{0.0};
};

// The rectangle lo..hi (x, z) between two heights.
inline Box boxOf(glm::dvec2 lo, glm::dvec2 hi, const HeightBounds& heights) {
  return {{lo.x, heights.lowest, lo.y}, {hi.x, heights.highest, hi.y}};
}

// A four-sided pyramid with its tip in the eye and no base. It has no near plane either: what is nearer than
// the near plane counts as visible.
struct ViewVolume {
  glm::dvec3 position{0.0};            // of the eye, world metres
  std::array<glm::dvec3, 4> inward{};  // unit normals of the sides, pointing inwards
  std::array<glm::dvec3, 4> edges{};   // directions of the edges (the corners of the picture), not normalised
  double pixelsPerRadian = 1;          // in the middle of the picture
  // Others whose boxes count as visible too: views of the same land that are drawn with the detail of this
  // one, from eyes no nearer to any of it (a mirrored view). Those of these do not count.
  std::vector<ViewVolume> beside = {};
};

// worldToView turns world directions into view ones (x right, y up, the view looks along -z); it must be
// orthonormal. fovYRad is the full vertical angle, 0 < fovYRad < pi; width and height in pixels, at least 1.
ViewVolume makeViewVolume(glm::dvec3 position, const glm::dmat3& worldToView, double fovYRad, int width,
                          int height);

// False only if no point of the box is inside the volume or one beside it. True for boxes inside and for
// nearly all that touch it: of the separating axes those of the sides and of the box are tried, those of
// pairs of edges are not.
bool mayBeVisible(const ViewVolume& view, const Box& box);

// Distance from the eye to the nearest point of the box, metres.
double nearestDistance(const ViewVolume& view, const Box& box);

// The same on the ground plane, for the rectangle under the box.
double nearestGroundDistance(const ViewVolume& view, const Box& box);

}  // namespace skydrop::terrain
