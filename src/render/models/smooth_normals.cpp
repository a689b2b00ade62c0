#include "render/models/smooth_normals.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

namespace skydrop::render {
namespace {

// Of the sum of angles (radians): shorter sums of normals are what rounding leaves of opposite ones.
constexpr double kLeastSum = 1e-6;

struct Sum {
  glm::dvec3 normal{0};
  double angles = 0;

  void operator+=(const Sum& other) { normal += other.normal, angles += other.angles; }
  bool hasDirection() const { return glm::length(normal) > kLeastSum * angles; }
};

// What each vertex gets of its own triangles.
std::vector<Sum> ownSums(const MeshData& mesh) {
  std::vector<Sum> sums(mesh.vertices.size());
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const std::uint32_t corners[3] = {mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]};
    const auto place = [&](int k) { return glm::dvec3(mesh.vertices[corners[k % 3]].position); };
    const glm::dvec3 cross = glm::cross(place(1) - place(0), place(2) - place(0));
    const double area = glm::length(cross);
    if (!(area > 0)) continue;
    for (int k = 0; k < 3; ++k) {
      const glm::dvec3 a = place(k + 1) - place(k), b = place(k + 2) - place(k);
      const double angle = std::atan2(area, glm::dot(a, b));
      sums[corners[k]] += {cross / area * angle, angle};
    }
  }
  return sums;
}

}  // namespace

void addSmoothNormals(MeshData& mesh) {
  std::vector<std::uint32_t> order(mesh.vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto position = [&](std::uint32_t v) { return mesh.vertices[v].position; };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const glm::vec3 p = position(a), q = position(b);
    if (p.x != q.x) return p.x < q.x;
    if (p.y != q.y) return p.y < q.y;
    if (p.z != q.z) return p.z < q.z;
    return a < b;
  });
  const std::vector<Sum> own = ownSums(mesh);
  for (std::size_t first = 0, end = 0; first < order.size(); first = end) {
    Sum all;
    for (end = first; end < order.size() && position(order[end]) == position(order[first]); ++end) {
      all += own[order[end]];
    }
    for (std::size_t i = first; i < end; ++i) {
      glm::vec3& normal = mesh.vertices[order[i]].normal;
      if (normal != glm::vec3(0)) continue;
      const Sum& sum = all.hasDirection() ? all : own[order[i]];
      normal = sum.hasDirection() ? glm::vec3(glm::normalize(sum.normal)) : glm::vec3(0, 1, 0);
    }
  }
}

}  // namespace skydrop::render
