// The mesh of a cloud plane: a square of nine by nine segments around the eye. A value; any thread.
// Source: Tarantilis, "Simulating clouds with procedural texturing techniques using the GPU", 2004, chapter
// III: a rim of alpha 0 around inner vertices of alpha 1 hides the edge.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

namespace skydrop::render {

inline constexpr int kPlaneSegments = 9;  // a side

struct CloudPlaneVertex {
  glm::vec2 place;  // x and z, [-1, 1]: a share of the radius
  float alpha;      // 0 at the rim, else 1
};

struct CloudPlaneMesh {
  std::vector<CloudPlaneVertex> vertices;  // rows of kPlaneSegments + 1
  std::vector<std::uint16_t> indices;      // triangles
};

// Lines lie at the square of even steps: close around the eye, and with an outer ring of two fifths of the
// radius to fade over.
CloudPlaneMesh makeCloudPlaneMesh();

}  // namespace skydrop::render
