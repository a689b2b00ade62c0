// The shapes of trees, made by code: unit trees of height 1 whose crown has the radius 1, the stem at the
// origin and rooted a little below it.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace skydrop::render {

struct TreeVertex {
  glm::vec3 place{0};
  glm::vec3 normal{0};   // unit
  glm::vec2 surface{0};  // share of the sky that is open to it, [0, 1]; 1: bark, 0: leaves
};

struct TreeMesh {
  std::vector<TreeVertex> vertices;
  std::vector<std::uint16_t> indices;  // three a triangle, counter-clockwise seen from outside
  // What impostors are baked with: radius over height of a usual tree, and half the side over height of the
  // square that it is seen in from any direction.
  float slender = 0, reach = 0;
};

// By kind: kSpruce, kBroadleaf, kDwarfPine of shaders/shared/woods.glsl. The same bits at every call.
std::array<TreeMesh, 3> makeTreeMeshes();

}  // namespace skydrop::render
