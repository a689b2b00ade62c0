#pragma once

#include <glm/vec4.hpp>

#include "skydrop/render/gl/shader.h"

namespace skydrop::render {

// Rain and snow that lie on the land. A resource of the frame (FrameResources), published before land is
// drawn. It belongs to no effect, so that land need not know where it falls from. Programs that are compiled
// with kDefine show it (shaders/terrain/fallen.glsl); without one nothing of it is compiled.
struct FallenWater {
  static constexpr const char* kDefine = "FALLEN_WATER";

  double wet = 0;        // of the ground, [0, 1]
  double snow = 0;       // how much of it lies, [0, 1]
  double snowLineM = 0;  // height above the sea from which on it does
  glm::vec4 sky{0};      // rgb: radiance that puddles mirror at a slant, after exposure

  // For programs that include that file, in use.
  void set(gl::ShaderProgram& shader) const {
    shader.setVec4("fallen", glm::vec4(wet, snow, snowLineM, 0));
    shader.setVec4("fallenSky", sky);
  }
};

}  // namespace skydrop::render
