// A sphere of triangles. Pure; any thread.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <vector>

namespace skydrop::render {

struct Icosphere {
  std::vector<glm::vec3> points;          // unit vectors
  std::vector<std::array<int, 3>> faces;  // points, counter-clockwise seen from outside
};

// An icosahedron, each of whose faces is divided into four so many times, 0 or more.
Icosphere icosphere(int divisions);

}  // namespace skydrop::render
