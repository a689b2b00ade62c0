// What land leaves of the sun in the air above it: the heights of shade of a terrain::LandShade on the GPU.
// Made by whoever lights air (shaders/shadow/land_shade_volume.glsl), of the frame's LandShadowMap.
#pragma once

#include <glm/vec2.hpp>
#include <optional>

#include "skydrop/render/gl/shader.h"
#include "skydrop/render/gl/texture.h"
#include "skydrop/render/shadows/land_shadow_map.h"

namespace skydrop::render {

// Main thread, on the context's thread; must go before the context. Holds no GL object before the first
// take().
class LandShadeVolume {
 public:
  // Uploads the shade of the map, unless it is there: 4 bytes a texel and level (3 MiB for medium detail, in
  // steps of 1/65535 of the highest shade). Of a map without content: a texture without content.
  void take(gl::Context& context, const LandShadowMap& map);

  // Texture and uniforms for a program that includes shaders/shadow/land_shade_volume.glsl, in a frame seen
  // from an eye at (x, z).
  void bind(gl::ShaderProgram& shader, const glm::dvec2& eye) const;

 private:
  static constexpr GLuint kUnit = 9;  // as in the shader

  gl::Texture limbs_;
  std::optional<terrain::ShadeKey> taken_;
  terrain::ShadeKey key_;
  float scaleM_ = 1;  // m, of the largest code: of the highest shade, or the widest penumbra
};

}  // namespace skydrop::render
