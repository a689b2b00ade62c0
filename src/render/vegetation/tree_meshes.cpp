#include "render/vegetation/tree_meshes.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

#include "render/frame/icosphere.h"
#include "skydrop/core/hash.h"

namespace skydrop::render {
namespace {

constexpr float kTwoPi = 2 * std::numbers::pi_v<float>;
constexpr float kRootDepth = 0.05f;  // of a stem below its foot, of the height: slopes do not show it

glm::vec3 around(float angle, float radius, float height) {
  return {radius * std::cos(angle), height, radius * std::sin(angle)};
}

class Builder {
 public:
  Builder(std::uint64_t seed, float slender) : random_{seed, 0} { mesh.slender = slender; }

  float random(float low, float high) { return low + (high - low) * static_cast<float>(random_.nextUnit()); }

  std::uint16_t add(const TreeVertex& vertex) {
    mesh.vertices.push_back(vertex);
    return static_cast<std::uint16_t>(mesh.vertices.size() - 1);
  }
  void triangle(int a, int b, int c) {
    for (const int i : {a, b, c}) mesh.indices.push_back(static_cast<std::uint16_t>(i));
  }

  // A stem of five sides.
  void stem(float top, float bottomRadius, float topRadius) {
    constexpr int kSides = 5;
    const int first = static_cast<int>(mesh.vertices.size());
    for (int i = 0; i < kSides; ++i) {
      const float angle = kTwoPi * static_cast<float>(i) / kSides;
      add({around(angle, bottomRadius, -kRootDepth), around(angle, 1, 0), {0.7f, 1}});
      add({around(angle, topRadius, top), around(angle, 1, 0), {0.3f, 1}});
    }
    for (int i = 0; i < kSides; ++i) {
      const int a = first + 2 * i, b = first + 2 * ((i + 1) % kSides);
      triangle(a, a + 1, b);
      triangle(b, a + 1, b + 1);
    }
  }

  // A skirt of twigs: a star of points around the stem that hang down, lit above, dark below.
  void skirt(float top, float bottom, float radius, int points, float open) {
    const int apex = add({{0, top, 0}, {0, 1, 0}, {0.55f * open, 0}});
    const int under = add({{0, bottom + 0.45f * (top - bottom), 0}, {0, -1, 0}, {0.12f, 0}});
    const float turn = random(0, kTwoPi);
    const int first = static_cast<int>(mesh.vertices.size());
    const int rim = 2 * points;
    for (int i = 0; i < rim; ++i) {
      const bool tip = i % 2 == 0;
      const float angle =
          turn + kTwoPi * (static_cast<float>(i) + random(-0.2f, 0.2f)) / static_cast<float>(rim);
      const float out = radius * (tip ? random(0.88f, 1.0f) : random(0.60f, 0.72f));
      const float down = tip ? random(-0.012f, 0.012f) : 0.25f * (top - bottom);
      const glm::vec3 normal = glm::normalize(around(angle, 1, 0.85f));
      add({around(angle, out, bottom + down), normal, {open * (tip ? 1.0f : 0.75f), 0}});
    }
    for (int i = 0; i < rim; ++i) {
      const int a = first + i, b = first + (i + 1) % rim;
      triangle(apex, b, a);
      triangle(under, a, b);
    }
  }

  // A lump of leaves: an icosahedron, divided once or not, with dents. `middle` and `radii` in the unit tree;
  // normals lean towards those of the whole crown, so that its lumps are one crown.
  void lump(const glm::vec3& middle, const glm::vec3& radii, bool fine, const glm::vec3& crown) {
    const auto& [points, faces] = icosphere(fine ? 1 : 0);
    const float turn = random(0, kTwoPi);
    const int first = static_cast<int>(mesh.vertices.size());
    for (const glm::vec3& p : points) {
      const glm::vec3 d(p.x * std::cos(turn) + p.z * std::sin(turn), p.y,
                        p.z * std::cos(turn) - p.x * std::sin(turn));
      const glm::vec3 place = middle + d * radii * random(0.86f, 1.08f);
      const glm::vec3 squat(mesh.slender, 1, mesh.slender);
      const glm::vec3 ofLump = glm::normalize(d / (radii * squat));
      const glm::vec3 ofCrown = glm::normalize((place - crown) * squat);
      const glm::vec3 normal = glm::normalize(0.6f * ofLump + 0.4f * ofCrown);
      const float open =
          glm::clamp(0.52f + 0.5f * normal.y + 0.18f * (place.y - middle.y) / radii.y, 0.12f, 1.0f);
      add({place, normal, {open, 0}});
    }
    for (const auto& f : faces) triangle(first + f[0], first + f[1], first + f[2]);
  }

  TreeMesh mesh;

 private:
  core::RandomStream random_;
};

TreeMesh spruce() {
  Builder b(11, 0.17f);
  b.stem(0.30f, 0.12f, 0.07f);
  constexpr int kSkirts = 6;
  for (int i = 0; i < kSkirts; ++i) {
    const float t = static_cast<float>(i) / (kSkirts - 1);  // from the lowest
    const float bottom = 0.10f + 0.72f * t;
    const float top = std::min(bottom + 0.30f - 0.09f * t, 1.0f);
    b.skirt(i == kSkirts - 1 ? 1.0f : top, bottom, 1.0f - 0.86f * std::pow(t, 0.85f), i < 3 ? 6 : 4,
            0.62f + 0.38f * t);
  }
  b.mesh.reach = 0.56f;
  return b.mesh;
}

TreeMesh broadleaf() {
  Builder b(23, 0.30f);
  b.stem(0.45f, 0.085f, 0.05f);
  const glm::vec3 crown(0, 0.55f, 0);
  b.lump({0.02f, 0.66f, -0.03f}, {0.74f, 0.33f, 0.74f}, true, crown);
  constexpr int kLumps = 5;
  const float turn = b.random(0, kTwoPi);
  for (int i = 0; i < kLumps; ++i) {
    const float angle = turn + kTwoPi * (static_cast<float>(i) + b.random(-0.2f, 0.2f)) / kLumps;
    const float size = b.random(0.36f, 0.46f);
    b.lump(around(angle, b.random(0.48f, 0.58f), b.random(0.44f, 0.62f)), {size, 0.42f * size, size}, false,
           crown);
  }
  b.mesh.reach = 0.60f;
  return b.mesh;
}

TreeMesh dwarfPine() {
  Builder b(37, 0.5f);
  const glm::vec3 crown(0, 0.1f, 0);
  b.stem(0.3f, 0.08f, 0.06f);
  b.lump({0, 0.52f, 0}, {0.62f, 0.46f, 0.62f}, true, crown);
  b.lump({0.48f, 0.32f, 0.16f}, {0.50f, 0.34f, 0.46f}, false, crown);
  b.lump({-0.36f, 0.30f, 0.36f}, {0.48f, 0.33f, 0.52f}, false, crown);
  b.lump({-0.14f, 0.28f, -0.50f}, {0.52f, 0.34f, 0.44f}, false, crown);
  b.mesh.reach = 0.75f;
  return b.mesh;
}

}  // namespace

std::array<TreeMesh, 3> makeTreeMeshes() { return {spruce(), broadleaf(), dwarfPine()}; }

}  // namespace skydrop::render
