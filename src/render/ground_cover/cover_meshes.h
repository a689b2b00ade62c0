// The meshes of what stands on the ground, made by code. Plants are numbers that
// shaders/ground_cover/plant.glsl makes blades of, stones are balls that stone.glsl dents.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

namespace skydrop::render {

struct CoverMesh {
  std::vector<glm::vec4> vertices;
  std::vector<std::uint16_t> indices;  // three a triangle
};

inline constexpr std::size_t kCoverLists = 7;  // as in shaders/ground_cover/instance.glsl
inline constexpr std::size_t kTuftLists = 2;   // the first of them
inline constexpr std::size_t kPlantLists = 4;  // tufts, flowers and reeds
inline constexpr std::size_t kSmallLists = 5;  // and stones of few pixels

// Tufts with fine blades, tufts, flowers, reeds, stones of few pixels, stones, boulders. The same bits at
// every call.
std::array<CoverMesh, kCoverLists> makeCoverMeshes();

}  // namespace skydrop::render
