#include "render/ground_cover/cover_meshes.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <utility>

namespace skydrop::render {
namespace {

// As in shaders/ground_cover/plant.glsl.
constexpr float kBlade = 0, kHead = 1, kStalk = 2;
constexpr int kUsualBlades = 12, kFineBlades = 18;

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

CoverMesh ball(int splits) {
  const float g = (1 + std::sqrt(5.0f)) / 2;
  std::vector<glm::vec3> places = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                                   {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  std::vector<std::uint16_t> indices = {0, 11, 5,  0, 5,  1, 0, 1, 7, 0, 7,  10, 0, 10, 11, 1, 5, 9, 5, 11,
                                        4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3,  9,  4, 3,  4,  2, 3, 2, 6, 3,
                                        6, 8,  3,  8, 9,  4, 9, 5, 2, 4, 11, 6,  2, 10, 8,  6, 7, 9, 8, 1};
  for (int split = 0; split < splits; ++split) {
    std::map<std::pair<std::uint16_t, std::uint16_t>, std::uint16_t> middles;
    const auto middle = [&](std::uint16_t a, std::uint16_t b) {
      const auto [at, isNew] =
          middles.try_emplace(std::minmax(a, b), static_cast<std::uint16_t>(places.size()));
      if (isNew) places.push_back(0.5f * (places[a] + places[b]));
      return at->second;
    };
    std::vector<std::uint16_t> finer;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
      const std::uint16_t a = indices[i], b = indices[i + 1], c = indices[i + 2];
      const std::uint16_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca});
    }
    indices = std::move(finer);
    for (glm::vec3& place : places) place = glm::normalize(place);
  }
  CoverMesh mesh;
  for (const glm::vec3& place : places) mesh.vertices.emplace_back(glm::normalize(place), 0.0f);
  mesh.indices = std::move(indices);
  return mesh;
}

}  // namespace

std::array<CoverMesh, kCoverLists> makeCoverMeshes() {
  return {tuft(kFineBlades, true),
          tuft(kUsualBlades, false),
          headed(4, false, 7),
          headed(12, true, 4),
          ball(1),
          ball(2)};
}

}  // namespace skydrop::render
