#include "skydrop/render/models/mesh_data.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace skydrop::render {
namespace {

// Cosine of the worst angle between a triangle's winding and its vertices' normals; slivers at poles are left
// out.
float worstWinding(const MeshData& mesh) {
  float worst = 1;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const MeshVertex& a = mesh.vertices[mesh.indices[i]];
    const MeshVertex& b = mesh.vertices[mesh.indices[i + 1]];
    const MeshVertex& c = mesh.vertices[mesh.indices[i + 2]];
    const glm::vec3 cross = glm::cross(b.position - a.position, c.position - a.position);
    if (glm::length(cross) < 1e-5f) continue;
    worst = std::min(worst, glm::dot(glm::normalize(cross), glm::normalize(a.normal + b.normal + c.normal)));
  }
  return worst;
}

TEST(MeshData, sphereNormalsAreItsPositions) {
  // On a sphere of radius 3 normal and position agree, poles included. Limit: float rounding of the position.
  const MeshData mesh = sphereMesh(3, 32, 16);
  EXPECT_EQ(mesh.vertices.size(), 33u * 17u);
  EXPECT_EQ(mesh.indices.size(), 32u * 16u * 6u);
  for (const MeshVertex& vertex : mesh.vertices) {
    EXPECT_NEAR(glm::length(vertex.position), 3.0f, 1e-6f);
    EXPECT_NEAR(glm::distance(vertex.normal, vertex.position / 3.0f), 0.0f, 2e-6f);
  }
  EXPECT_GT(worstWinding(mesh), 0.9f);
}

TEST(MeshData, torusNormalsPointAwayFromTheRing) {
  // The normal of a torus leads from the circle in its tube to the surface.
  const MeshData mesh = torusMesh(2, 0.5, 40, 20);
  for (const MeshVertex& vertex : mesh.vertices) {
    const glm::vec3 ring = 2.0f * glm::normalize(glm::vec3(vertex.position.x, 0, vertex.position.z));
    EXPECT_NEAR(glm::distance(vertex.normal, (vertex.position - ring) / 0.5f), 0.0f, 2e-6f);
  }
  EXPECT_GT(worstWinding(mesh), 0.9f);
}

TEST(MeshData, planeFacesUpAndHasItsSize) {
  // A plane of 6 m by 2 m around the origin.
  const MeshData mesh = planeMesh(6, 2, 3, 2);
  for (const MeshVertex& vertex : mesh.vertices) EXPECT_EQ(vertex.normal, glm::vec3(0, 1, 0));
  EXPECT_EQ(mesh.vertices.front().position, glm::vec3(-3, 0, -1));
  EXPECT_EQ(mesh.vertices.back().position, glm::vec3(3, 0, 1));
  EXPECT_GT(worstWinding(mesh), 0.999f);
}

TEST(MeshData, everySizeOfSphereHasItsNormals) {
  // Nothing in the search for poles depends on the unit: a millimetre and a thousand kilometres.
  for (const double radius : {1e-3, 1e6}) {
    for (const MeshVertex& vertex : sphereMesh(radius, 12, 6).vertices) {
      EXPECT_NEAR(glm::distance(vertex.normal, vertex.position / static_cast<float>(radius)), 0.0f, 2e-6f);
    }
  }
}

}  // namespace
}  // namespace skydrop::render
