// A picture of the ground on the GPU, for shaders that light the land (shaders/terrain/ground_picture.glsl).
#pragma once

#include <glm/vec2.hpp>

#include "skydrop/render/gl/shader.h"
#include "skydrop/render/gl/texture.h"
#include "skydrop/terrain/ground_picture.h"

namespace skydrop::render {

// On the context's thread; must go before the context.
class GroundTexture {
 public:
  static constexpr const char* kDefine = "GROUND_PICTURE";

  // Uploads all levels: 4 bytes a texel.
  GroundTexture(gl::Context& context, const terrain::GroundPicture& picture);

  // Texture and uniforms for a program of that define, in use, whose places are metres from `base` (x, z).
  void set(gl::Shader& shader, const glm::dvec2& base, const terrain::GroundPictureSettings& settings) const;

  const gl::Texture& texture() const { return texture_; }

 private:
  static constexpr GLuint kUnit = 5;  // as in the shader

  gl::Texture texture_;
  glm::dvec2 corner_, size_;  // m
  double texelM_;
};

}  // namespace skydrop::render
