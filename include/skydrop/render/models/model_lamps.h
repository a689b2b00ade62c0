#pragma once

#include <array>
#include <glm/vec4.hpp>

namespace skydrop::render {

// Lamps that light a model beside sun and sky, from all sides and without shadows. As in
// shaders/models/lamps.glsl.
struct ModelLamps {
  static constexpr const char* kDefine = "MODEL_LAMPS";
  static constexpr std::size_t kMost = 6;

  std::array<glm::vec4, kMost> places{};  // relative to the eye, m
  std::array<glm::vec4, kMost> lights{};  // intensity, kcd, times exposure; 0 where there is no lamp
};

}  // namespace skydrop::render
