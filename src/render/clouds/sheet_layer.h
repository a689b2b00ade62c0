// A target with fewer pixels than the picture, in which a cloud sheet's light is worked out before it is laid
// over the scene. Main thread, on the context's thread.
#pragma once

#include <string>

#include "skydrop/clouds/sheet_resolution.h"
#include "skydrop/render/frame/view.h"
#include "skydrop/render/gl/frame_buffer.h"

namespace skydrop::render {

class SheetLayer {
 public:
  // Makes nothing before the first begin(). The context must outlive it.
  // Floats of 32 bits are mixed in a third of the time by a software renderer, for twice the memory.
  SheetLayer(gl::Context& context, std::string label, GLenum format = GL_RGBA16F)
      : context_(context), label_(std::move(label)), format_(format) {}

  // Makes the layer the target, cleared, with a viewport that shows what the picture shows. Not for full
  // resolution.
  void begin(const View& view, clouds::SheetResolution resolution);
  // Gives target and viewport back, and binds what was drawn (light and opacity, multiplied together) to a
  // unit.
  void end(GLuint textureUnit);
  // What it holds, for a sheet that is drawn in full resolution from now on.
  void release() { target_ = {}; }

 private:
  gl::Context& context_;
  std::string label_;
  GLenum format_;
  gl::FrameBuffer target_;
};

}  // namespace skydrop::render
