#include "render/ground_cover/cover_meshes.h"

#include <initializer_list>

#include "render/frame/icosphere.h"

namespace skydrop::render {
namespace {

// As in shaders/ground_cover/plant.glsl.
constexpr float kBlade = 0, kHead = 1, kStalk = 2;
constexpr int kUsualBlades = 8, kFineBlades = 18;

void add(CoverMesh& mesh, std::size_t first, std::initializer_list<int> triangles) {
  for (const int i : triangles)
    mesh.indices.push_back(static_cast<std::uint16_t>(first + static_cast<std::size_t>(i)));
}

void addBlade(CoverMesh& mesh, int number, float part, bool isFine) {
  const auto n = static_cast<float>(number);
  const std::size_t first = mesh.vertices.size();
  if (isFine) {
    mesh.vertices.insert(
        mesh.vertices.end(),
        {{n, 0, -1, part}, {n, 0, 1, part}, {n, 0.55f, -1, part}, {n, 0.55f, 1, part}, {n, 1, 0, part}});
    add(mesh, first, {0, 1, 2, 2, 1, 3, 2, 3, 4});
  } else {
    mesh.vertices.insert(mesh.vertices.end(), {{n, 0, -1, part}, {n, 0, 1, part}, {n, 1, 0, part}});
    add(mesh, first, {0, 1, 2});
  }
}

void addHead(CoverMesh& mesh, int number) {
  const auto n = static_cast<float>(number);
  const std::size_t first = mesh.vertices.size();
  mesh.vertices.insert(
      mesh.vertices.end(),
      {{n, 0, 0, kHead}, {n, -1, 0, kHead}, {n, 0, -1, kHead}, {n, 1, 0, kHead}, {n, 0, 1, kHead}});
  add(mesh, first, {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1});
}

CoverMesh tuft(int blades, bool areFine) {
  CoverMesh mesh;
  for (int i = 0; i < blades; ++i) addBlade(mesh, i, kBlade, areFine);
  return mesh;
}

CoverMesh headed(int blades, bool areFine, int heads) {
  CoverMesh mesh = tuft(blades, areFine);
  for (int i = blades; i < blades + heads; ++i) {
    addBlade(mesh, i, kStalk, false);
    addHead(mesh, i);
  }
  return mesh;
}

CoverMesh ball(int divisions) {
  const auto& [points, faces] = icosphere(divisions);
  CoverMesh mesh;
  for (const glm::vec3& point : points) mesh.vertices.emplace_back(point, 0.0f);
  for (const auto& [a, b, c] : faces) add(mesh, 0, {a, b, c});
  return mesh;
}

}  // namespace

std::array<CoverMesh, kCoverLists> makeCoverMeshes() {
  return {tuft(kFineBlades, true),
          tuft(kUsualBlades, false),
          headed(4, false, 7),
          headed(12, true, 4),
          ball(0),
          ball(1),
          ball(2)};
}

}  // namespace skydrop::render
