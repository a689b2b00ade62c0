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
  static constexpr const char* kDefine = "LAND_SHADE";

  // Uploads the shade, which must outlive its use here: 2 bytes a texel and level (1.5 MiB for medium
  // detail).
  void take(gl::Context& context, const terrain::LandShade& shade);

  // A texture without content in its place, for frames that nobody sees.
  void takeNone(gl::Context& context, const terrain::ShadeLayout& layout);

  // Texture and uniforms for a program that includes shaders/shadow/land_shadow_map.glsl, in a frame seen
  // from an eye at (x, z).
  void bind(gl::ShaderProgram& shader, const glm::dvec2& eye) const;

  // What it was made of: valid as long as the pass that published it keeps it, in the frame at least. Null
  // for a texture without content.
  const terrain::LandShade* shade() const { return shade_; }
  const terrain::ShadeKey& key() const { return key_; }

  // The uniforms shadeAxes and shadeLevels: where texels of a shade lie in a frame seen from an eye at (x,
  // z).
  static void setPlaces(gl::ShaderProgram& shader, const terrain::ShadeKey& key, const glm::dvec2& eye);

 private:
  static constexpr GLuint kUnit = 13;  // as in the shader

  void makeTexture(gl::Context& context);

  gl::Texture clearances_;
  terrain::ShadeKey key_;
  const terrain::LandShade* shade_ = nullptr;
};

}  // namespace skydrop::render
