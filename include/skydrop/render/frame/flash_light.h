#pragma once

#include <array>
#include <glm/vec4.hpp>

#include "skydrop/render/gl/shader.h"

namespace skydrop::render {

// A flash of lightning as points of light along its channel, for what it lights: land, sea, models. A
// resource of the frame (FrameResources), published before land is drawn, in frames in which one shines. It
// belongs to no effect, so that those who are lit need not know of weather. Programs that are compiled with
// kDefine have its light (shaders/flash_light.glsl); without one nothing of it is compiled.
struct FlashLight {
  static constexpr const char* kDefine = "FLASH_LIGHT";
  static constexpr std::size_t kLights = 8;  // as there

  // xyz: relative to the eye, m; w: square of the length over which the light is spread, m^2, above 0.
  std::array<glm::vec4, kLights> places{};
  // rgb: intensity, kcd, times the frame's exposure; a: 1 in open air, 0 within a cloud.
  std::array<glm::vec4, kLights> lights{};

  // For programs that include that file, in use or not.
  void set(gl::ShaderProgram& shader) const {
    shader.setVec4s("flashPlaces", places);
    shader.setVec4s("flashLights", lights);
  }
};

}  // namespace skydrop::render
