#include "render/clouds/sheet_layer.h"

#include <cassert>

namespace skydrop::render {

void SheetLayer::begin(const View& view, clouds::SheetResolution resolution) {
  const int pixels = clouds::pixelsAlong(resolution);
  assert(pixels > 1);
  const int width = (view.width + pixels - 1) / pixels, height = (view.height + pixels - 1) / pixels;
  if (!target_)
    target_ = gl::FrameBuffer(context_, width, height, gl::FrameBufferFormat{format_, 0}, label_);
  else
    target_.resize(width, height);
  target_.bind();
}

void SheetLayer::end(GLuint textureUnit) {
  target_.unBind();
  target_.colorTexture().bind(textureUnit);
}

}  // namespace skydrop::render
