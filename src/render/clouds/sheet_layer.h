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
  SheetLayer(gl::Context& context, std::string label) : context_(context), label_(std::move(label)) {}

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
  gl::FrameBuffer target_;
};

}  // namespace skydrop::render
