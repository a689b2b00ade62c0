#pragma once

#include <cstdint>
#include <string_view>

#include "skydrop/render/models/model_import.h"

namespace skydrop::render {

// How much there is to draw.
struct GltfMeshSize {
  std::uint64_t vertices = 0, indices = 0;

  void operator+=(const GltfMeshSize& other) {
    vertices += other.vertices;
    indices += other.indices;
  }
  bool isTooLarge() const { return vertices > kMaxModelVertices || indices > kMaxModelIndices; }
};

}  // namespace skydrop::render
