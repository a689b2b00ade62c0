// What clouds leave of the sun on land and sea: the optical depth of the whole layer along each sun ray, in a
// fine grid near the eye and a coarse one out to where clouds have faded. A resource of the frame
// (FrameResources), published by CloudShadowPass, read by whoever lights a surface below the layer
// (shaders/clouds/shadow_map.glsl).
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "skydrop/render/gl/shader.h"
#include "skydrop/render/gl/texture.h"

namespace skydrop::render {

class CloudShadowMap {
 public:
  // A texture, kept alive by the cloud system, and rows that carry a place relative to the eye (and 1) to
  // its coordinates. It holds at least the rays that meet sea level this far from below the eye.
  struct Map {
    const gl::Texture* depths = nullptr;
    std::array<glm::vec4, 2> rows{};
    double radiusM = 0;
  };

  // Nothing to bind.
  CloudShadowMap() = default;
  // baseM: of the layer, above the eye.
  CloudShadowMap(const Map& fine, const Map& coarse, double baseM, double thicknessM)
      : fine_(fine), coarse_(coarse), layer_(baseM, 1 / thicknessM) {}

  // Textures and uniforms for a program that includes shaders/clouds/shadow_map.glsl.
  void bind(gl::Shader& shader) const;

 private:
  static constexpr GLuint kFineUnit = 10, kCoarseUnit = 11;  // as in shaders/clouds/shadow_map.glsl

  Map fine_, coarse_;
  glm::vec2 layer_{0};
};

}  // namespace skydrop::render
