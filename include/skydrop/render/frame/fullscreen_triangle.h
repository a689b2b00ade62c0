#pragma once

#include "skydrop/render/gl/vertex_array.h"

namespace skydrop::render {

// Draws every pixel of the target once, at infinity; the vertex shader is fullscreen.vert, which hands on
// `ndc`.
class FullscreenTriangle {
 public:
  explicit FullscreenTriangle(gl::Context& context) : empty_(context, "full screen") {}
  void draw() const {
    empty_.bind();
    empty_.context().drawArrays(GL_TRIANGLES, 0, 3);
  }

 private:
  gl::VertexArray empty_;
};

}  // namespace skydrop::render
