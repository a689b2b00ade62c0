// What land leaves of the sun on land and sea: the clearances of a terrain::LandShade on the GPU. A resource
// of the frame (FrameResources), published by LandShadowPass, read by whoever lights a surface of the land
// (shaders/shadow/land_shadow_map.glsl).
#pragma once

#include <glm/vec2.hpp>

#include "skydrop/render/gl/shader.h"
#include "skydrop/render/gl/texture.h"
#include "skydrop/terrain/land_shade.h"

namespace skydrop::render {

// Main thread, on the context's thread; must go before the context. Holds no GL object before the first
// take().
class LandShadowMap {
 public:
  // Uploads the shade: 2 bytes a texel and level (1.5 MiB for medium detail).
  void take(gl::Context& context, const terrain::LandShade& shade);

  // A texture without content in its place, for frames that nobody sees.
  void takeNone(gl::Context& context, const terrain::ShadeLayout& layout);

  // Texture and uniforms for a program that includes shaders/shadow/land_shadow_map.glsl, in a frame seen
  // from an eye at (x, z).
  void bind(gl::Shader& shader, const glm::dvec2& eye) const;

 private:
  static constexpr GLuint kUnit = 13;  // as in the shader

  void makeTexture(gl::Context& context);

  gl::Texture clearances_;
  terrain::ShadeKey key_;
};

}  // namespace skydrop::render
