#pragma once

#include "skydrop/render/gl/frame_buffer.h"

namespace skydrop::render {

// Where the depth of a view's land, and what shadows leave of its light, are drawn before it is lit, in place
// of the target that the pass of the land has for the scene. A resource of the frame (FrameResources) of
// views beside the scene's; not null, made by makeLandSurface() and as large as the view.
struct LandSurface {
  gl::FrameBuffer* target = nullptr;
};

// RGBA16F, cleared to the light of the open sky (kOpenSky of shaders/frame.glsl), and D32F. Pixels.
inline gl::FrameBuffer makeLandSurface(gl::Context& context, int width, int height) {
  gl::FrameBuffer surface(context, width, height, {GL_RGBA16F, GL_DEPTH_COMPONENT32F}, "land surface");
  surface.setClearColor(1, 1, 0, 1);
  return surface;
}

}  // namespace skydrop::render
