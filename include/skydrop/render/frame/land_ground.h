#pragma once

#include <glm/vec2.hpp>

#include "skydrop/render/frame/view.h"
#include "skydrop/render/gl/shader.h"

namespace skydrop::render {

// The land of a frame, for what stands on it. A resource of the frame (FrameResources), published by the pass
// that draws the land; whoever stands on it need not know that pass.
class LandGround {
 public:
  virtual ~LandGround() = default;
  // Textures and uniforms of a program in use that includes shaders/terrain/land.glsl and
  // terrain/drawn_height.glsl.
  virtual void setGround(gl::ShaderProgram& shader, const View& view) const = 0;
  // The same of one that includes terrain/surface.glsl alone.
  virtual void setSurface(gl::ShaderProgram& shader, const View& view) const = 0;
  // World position (x, z) from which such programs count: a chunk corner near the eye, m.
  virtual glm::dvec2 base() const = 0;
  // Plants grow as high as on the earth: such programs are compiled with ALPINE_BELTS.
  virtual bool hasAlpineBelts() const = 0;
};

}  // namespace skydrop::render
