#pragma once

#include <glm/vec4.hpp>

#include "skydrop/core/shared_ground_detail.h"
#include "skydrop/render/gl/shader.h"
#include "skydrop/render/gl/texture.h"

namespace skydrop::render {

// What the ground looks like from a few metres. A resource of the frame (FrameResources), published before
// land is drawn. Programs that are compiled with kDefine show it (shaders/terrain/ground_detail.glsl);
// without one nothing of it is compiled.
struct GroundDetail {
  static constexpr const char* kDefine = "GROUND_DETAIL";
  static constexpr GLuint kUnit = 6;  // as in the shader

  const gl::Texture* squares = nullptr;        // squares of terrain::GroundMaterial, a layer each
  double contrast = 1, relief = 1, reach = 1;  // as terrain::GroundDetailSettings
  double texelM = 1;                           // side of a texel of the first level, m
  double erosion = 1;                          // as there

  static constexpr double kWideScale = 8, kWideReach = 0.35;  // of the larger squares of plain land, as there
  // From so far on plain land shows nothing of it, m. pixelAngleRad: of a pixel in the picture's middle.
  double plainReachM(double pixelAngleRad) const {
    return core::shared::f64::kDetailFadedM * kWideScale * kWideReach * reach / pixelAngleRad;
  }

  // For programs that include that file, in use.
  void set(gl::Shader& shader) const {
    squares->bind(kUnit);
    shader.setVec4("groundDetail", glm::vec4(contrast, relief, reach, texelM));
    shader.setFloat("erosionDepth", static_cast<float>(erosion));
  }
};

}  // namespace skydrop::render
