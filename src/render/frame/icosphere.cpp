#include "render/frame/icosphere.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <utility>

namespace skydrop::render {
namespace {

void icosahedron(std::vector<glm::vec3>& points, std::vector<std::array<int, 3>>& faces) {
  const float g = std::numbers::phi_v<float>;
  for (const float a : {-1.0f, 1.0f}) {
    for (const float b : {-g, g}) {
      points.push_back(glm::normalize(glm::vec3(0, a, b)));
      points.push_back(glm::normalize(glm::vec3(a, b, 0)));
      points.push_back(glm::normalize(glm::vec3(b, 0, a)));
    }
  }
  // Any three that are neighbours (1.05 apart) are a face.
  const auto isEdge = [&](std::size_t i, std::size_t j) {
    return glm::distance(points[i], points[j]) < 1.2f;
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      for (std::size_t k = j + 1; k < points.size(); ++k) {
        if (!isEdge(i, j) || !isEdge(j, k) || !isEdge(i, k)) continue;
        const glm::vec3 normal = glm::cross(points[j] - points[i], points[k] - points[i]);
        const bool outwards = glm::dot(normal, points[i]) > 0;
        const int a = static_cast<int>(i), b = static_cast<int>(j), c = static_cast<int>(k);
        faces.push_back({a, outwards ? b : c, outwards ? c : b});
      }
    }
  }
}

void divide(std::vector<glm::vec3>& points, std::vector<std::array<int, 3>>& faces) {
  std::map<std::pair<int, int>, int> middles;
  const auto middleOf = [&](int a, int b) {
    const auto [found, isNew] = middles.try_emplace(std::minmax(a, b), static_cast<int>(points.size()));
    if (isNew)
      points.push_back(
          glm::normalize(points[static_cast<std::size_t>(a)] + points[static_cast<std::size_t>(b)]));
    return found->second;
  };
  std::vector<std::array<int, 3>> finer;
  for (const auto& [a, b, c] : faces) {
    const int ab = middleOf(a, b), bc = middleOf(b, c), ca = middleOf(c, a);
    for (const std::array<int, 3>& f : {std::array{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
      finer.push_back(f);
  }
  faces = std::move(finer);
}

}  // namespace

Icosphere icosphere(int divisions) {
  Icosphere sphere;
  icosahedron(sphere.points, sphere.faces);
  for (int i = 0; i < divisions; ++i) divide(sphere.points, sphere.faces);
  return sphere;
}

}  // namespace skydrop::render
