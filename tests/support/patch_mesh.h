// The mesh of a patch as the vertex shader makes it, on the CPU: for tests of its geometry.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <unordered_map>
#include <vector>

#include "skydrop/terrain/terrain_frame.h"

namespace skydrop::test {

class PatchMesher {
 public:
  explicit PatchMesher(const terrain::HeightSource& source) : source_(source) {}

  static constexpr int kSide = terrain::kPatchCells + 1;

  // World positions, row-major from the north-west corner, seen from `eye`.
  std::array<glm::dvec3, kSide * kSide> vertices(const terrain::TerrainFrame& frame,
                                                 const terrain::PatchDraw& patch, const glm::dvec3& eye);

 private:
  float storedHeight(const glm::dvec2& xz);

  const terrain::HeightSource& source_;
  std::unordered_map<terrain::ChunkKey, float, terrain::ChunkKeyHash> heights_;  // by position
};

// Corners of the 450 triangles, counter-clockwise seen from above.
const std::vector<std::array<int, 3>>& patchTriangles();

}  // namespace skydrop::test
