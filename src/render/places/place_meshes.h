// The shapes of buildings and hedges, made by code; their vertices are put where instances say by
// shaders/places/house_mesh.glsl and hedge_mesh.glsl.
#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

namespace skydrop::render {

struct PlaceVertex {
  glm::vec4 corner{0}, normal{0};  // as in those files
};

struct PlaceMesh {
  std::vector<PlaceVertex> vertices;
  std::vector<std::uint16_t> indices;  // three a triangle
};

PlaceMesh makeHouseMesh();
PlaceMesh makeHedgeMesh();

}  // namespace skydrop::render
