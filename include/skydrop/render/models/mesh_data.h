// Triangles on the CPU, and surfaces from a mapping f(u, v). No GL: any thread.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace skydrop::render {

struct MeshVertex {
  glm::vec3 position{0};  // metres in the model's space
  glm::vec3 normal{0, 1, 0};
  glm::vec2 uv{0};
};

// Triangles wind counter-clockwise seen from the side that the normals point to.
struct MeshData {
  std::vector<MeshVertex> vertices;
  std::vector<std::uint32_t> indices;  // three a triangle
};

// A point for (u, v), both in [0, 1]. Must be smooth, and may be evaluated a little outside.
using SurfaceMapping = std::function<glm::dvec3(double u, double v)>;

// (uCells + 1) x (vCells + 1) vertices. The normal is the direction of df/dv x df/du, by central differences
// of the mapping itself; where that vanishes (the pole of a sphere) it is continued from further inside.
MeshData meshFromMapping(const SurfaceMapping& mapping, int uCells, int vCells);

// The thesis's three: all outward or upward, centred on the origin.
MeshData sphereMesh(double radius, int uCells, int vCells);
MeshData torusMesh(double ringRadius, double tubeRadius, int uCells, int vCells);  // around the y axis
MeshData planeMesh(double sizeX, double sizeZ, int uCells, int vCells);            // y = 0, facing up

}  // namespace skydrop::render
