#pragma once

#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "skydrop/render/frame/view.h"
#include "skydrop/render/gl/shader.h"

namespace skydrop::render {

// A lamp that lights the land. A resource of the frame (FrameResources), published before land is drawn. It
// belongs to no effect, so that land need not know who carries the lamp. Programs that are compiled with
// kDefine have its light (shaders/terrain/spot.glsl); without one nothing of it is compiled.
struct SpotLight {
  static constexpr const char* kDefine = "SPOT_LIGHT";

  glm::dvec3 position{0};     // world, m
  glm::dvec3 axis{0, -1, 0};  // unit, the way of the light
  double halfAngleRad = 0.1;  // from the axis to where the intensity is half; above 0
  glm::dvec3 intensity{0};    // on the axis, kcd, linear sRGB primaries, times the frame's exposure

  // For programs that include that file, in use.
  void set(gl::ShaderProgram& shader, const View& view) const {
    shader.setVec3("spotPlace", relativeToEye(view, position));
    shader.setVec4("spotAxis", glm::vec4(glm::vec3(axis), static_cast<float>(halfAngleRad)));
    shader.setVec3("spotLight", glm::vec3(intensity));
  }
};

}  // namespace skydrop::render
