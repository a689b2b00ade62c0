// A plane of noise as a picture that repeats. For the noise tool.
#pragma once

#include <cstddef>
#include <span>

#include "skydrop/render/gl/texture.h"

namespace skydrop::render {

// On the context's thread; owns its texture.
class NoisePlaneView {
 public:
  // How a value looks: as grey, or as white with the value as alpha.
  enum class Look { grey, alpha };

  explicit NoisePlaneView(gl::Context& context) : context_(context) {}

  // width * height bytes, the first row on top.
  void show(int width, int height, std::span<const std::byte> values, Look look);

  // Empty before show(). v = 0 is the first row.
  const gl::Texture& picture() const { return picture_; }

 private:
  gl::Context& context_;
  gl::Texture picture_;
};

}  // namespace skydrop::render
