#include "render/places/place_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <numbers>

namespace skydrop::render {
namespace {

constexpr float kSkirt = 0, kEaves = 2, kRidge = 3;  // levels, parts: as in shaders/places/house_mesh.glsl
constexpr float kWall = 0, kGable = 1, kSlope = 2, kHip = 3, kChimney = 4;

// A convex face of its own vertices, counter-clockwise seen from outside: in the world, where x across a
// building and z along it are mirrored.
void addFace(PlaceMesh& mesh, std::initializer_list<glm::vec4> corners, const glm::vec3& normal) {
  const auto first = static_cast<std::uint16_t>(mesh.vertices.size());
  for (const glm::vec4& corner : corners) mesh.vertices.push_back({corner, glm::vec4(normal, 0)});
  const auto place = [&](std::size_t i) {
    const glm::vec4& corner = mesh.vertices[first + i].corner;
    return glm::vec3(corner.x, corner.z, corner.y);
  };
  const bool turns = glm::dot(glm::cross(place(1) - place(0), place(2) - place(0)), normal) > 0;
  for (int i = 2; i < static_cast<int>(corners.size()); ++i) {
    for (const int k : {0, turns ? i : i - 1, turns ? i - 1 : i})
      mesh.indices.push_back(static_cast<std::uint16_t>(first + k));
  }
}

void addWalls(PlaceMesh& mesh, float low, float high, float part) {
  for (const float s : {-1.0f, 1.0f}) {
    addFace(mesh, {{s, -1, low, part}, {s, 1, low, part}, {s, 1, high, part}, {s, -1, high, part}},
            {s, 0, 0});
    addFace(mesh, {{-1, s, low, part}, {1, s, low, part}, {1, s, high, part}, {-1, s, high, part}},
            {0, 0, s});
  }
}

}  // namespace

PlaceMesh makeHouseMesh() {
  PlaceMesh mesh;
  addWalls(mesh, kSkirt, kEaves, kWall);
  for (const float s : {-1.0f, 1.0f}) {
    addFace(mesh, {{-1, s, kEaves, kGable}, {1, s, kEaves, kGable}, {0, s, kRidge, kGable}}, {0, 0, s});
    addFace(
        mesh,
        {{s, -1, kEaves, kSlope}, {s, 1, kEaves, kSlope}, {s, 1, kRidge, kSlope}, {s, -1, kRidge, kSlope}},
        {s, 1, 0});
    addFace(mesh, {{-1, s, kEaves, kHip}, {1, s, kEaves, kHip}, {0, s, kRidge, kHip}}, {0, 1, s});
  }
  addWalls(mesh, kSkirt, kEaves, kChimney);
  addFace(mesh,
          {{-1, -1, kEaves, kChimney},
           {1, -1, kEaves, kChimney},
           {1, 1, kEaves, kChimney},
           {-1, 1, kEaves, kChimney}},
          {0, 1, 0});
  return mesh;
}

PlaceMesh makeHedgeMesh() {
  constexpr std::array kSections{-1.0f, -0.85f, -0.3f, 0.3f, 0.85f, 1.0f};
  constexpr int kAlong = static_cast<int>(kSections.size());
  constexpr int kRound = 5;  // vertices of each, from foot to foot over the top
  PlaceMesh mesh;
  for (int i = 0; i < kAlong; ++i) {
    const float z = kSections[static_cast<std::size_t>(i)];
    for (int k = 0; k < kRound; ++k) {
      const float angle = std::numbers::pi_v<float> * static_cast<float>(k) / (kRound - 1);
      const float round = std::sqrt(1 - 0.98f * z * z * z * z);  // towards its ends
      const float x = -std::cos(angle) * round, y = std::pow(std::max(std::sin(angle), 0.0f), 0.6f) * round;
      const glm::vec3 normal = glm::normalize(glm::vec3(x, 0.25f + std::sin(angle), 0.6f * z * z * z));
      const float dent = 0.14f * std::sin(12.9898f * static_cast<float>(i) + 78.233f * static_cast<float>(k));
      mesh.vertices.push_back(
          {{x, y < 1e-3f ? 0 : y, z, dent}, glm::vec4(normal, 0.35f + 0.65f * std::min(y, 1.0f))});
    }
  }
  for (int i = 0; i + 1 < kAlong; ++i) {
    for (int k = 0; k + 1 < kRound; ++k) {
      const int a = i * kRound + k, b = a + kRound;
      for (const int v : {a, a + 1, b, a + 1, b + 1, b})
        mesh.indices.push_back(static_cast<std::uint16_t>(v));
    }
  }
  return mesh;
}

}  // namespace skydrop::render
