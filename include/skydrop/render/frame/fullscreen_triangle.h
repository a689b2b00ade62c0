#pragma once

#include "skydrop/render/gl/vertex_array.h"

namespace skydrop::render {

// Draws every pixel of the viewport once, at infinity: reversed depth 0, which passes the default depth test
// (GEQUAL) only where nothing was drawn. On the context's thread; must go before its context. Has no vertex
// buffer.
class FullscreenTriangle {
 public:
  explicit FullscreenTriangle(gl::Context& context) : empty_(context, "full screen") {}
  // One draw call with the program in use, whose vertex shader is fullscreen.vert: it hands `vec2 ndc` on, in
  // [-1, 1] from the lower left corner to the upper right one. Target and state are the caller's.
  void draw() const {
    empty_.bind();
    empty_.context().drawArrays(GL_TRIANGLES, 0, 3);
  }

 private:
  gl::VertexArray empty_;
};

}  // namespace skydrop::render
