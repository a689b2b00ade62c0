// A picture of a volume of noise: the cube, turned, as if it held clouds. For the noise tool.
#pragma once

#include "skydrop/core/dds.h"
#include "skydrop/render/gl/shader.h"
#include "skydrop/render/gl/texture.h"

namespace skydrop::render {

// On the context's thread; owns its textures.
class NoiseVolumeView {
 public:
  // The picture's side in pixels. Throws core::DataError when the shader does not compile.
  NoiseVolumeView(gl::Context& context, int side);

  // An r8 volume.
  void show(const core::TextureData& volume);

  // Draws it, turned about the vertical by an angle in radians and seen from a little above. Density is what
  // lies above the threshold, [0, 1). Does nothing before show().
  void draw(double angleRad, double threshold);

  // RGBA8 with straight alpha; the first row is the lowest.
  const gl::Texture& picture() const { return picture_; }

 private:
  gl::Context& context_;
  gl::ComputeShader shader_;
  gl::Texture volume_, picture_;
};

}  // namespace skydrop::render
