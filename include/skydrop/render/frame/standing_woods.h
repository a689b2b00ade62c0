#pragma once

#include <glm/vec4.hpp>

#include "skydrop/render/gl/shader.h"

namespace skydrop::render {

// Trees that stand on the land, as its colour has to know: where they stand it shows the ground below them
// and their shadows, beyond it the woods as they are painted. A resource of the frame (FrameResources),
// published before land is drawn; programs that are compiled with kDefine show it
// (shaders/terrain/wood_floor.glsl), without one nothing of it is compiled.
struct StandingWoods {
  static constexpr const char* kDefine = "STANDING_WOODS";

  double fadeM = 0, farM = 0;  // painted woods come in between, m
  double shadowM = 0;          // up to this distance trees have shadows of their own, m
  double shadow = 0;           // their depth, [0, 1]
  double density = 1;          // share of the trees that there are, [0, 1]

  // For programs that include that file, in use.
  void set(gl::ShaderProgram& shader) const {
    shader.setVec4("standingReach", glm::vec4(fadeM, farM, shadowM, shadow));
    shader.setFloat("standingDensity", static_cast<float>(density));
  }
};

}  // namespace skydrop::render
