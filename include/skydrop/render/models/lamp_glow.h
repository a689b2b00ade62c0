#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "skydrop/render/frame/pass.h"
#include "skydrop/render/gl/vertex_array.h"

namespace skydrop::render {

// A lamp that is looked at.
struct Glow {
  glm::dvec3 position{0};   // world, m
  glm::dvec3 intensity{0};  // towards the eye, kcd, linear sRGB primaries
  double lensM = 0.03;      // radius of what shines
};

// Draws lamps as they are seen: the lens, spread over pixels so that its light is the lamp's, and the veil
// that the eye scatters around it (Stiles and Holladay; shaders/shared/lamp.glsl). Either saturates at
// kBrightestLens and kMostVeil: an eye adapts to a lamp as well as to the frame's light. By day both are far
// from that. What is nearer than the lamp hides it, clouds and air dim it. Owns no programs.
class LampGlow {
 public:
  static constexpr std::size_t kMost = 8;         // in one call; more are left out
  static constexpr double kBrightestLens = 4;     // after exposure
  static constexpr double kMostVeil = 0.05;       // after exposure, degree^2
  static constexpr double kFaintestVeil = 0.003;  // after exposure: where it ends

  explicit LampGlow(gl::Context& context) : empty_(context, "lamp glow") {}

  // In a pass of the stages translucents or weatherEffects. Throws core::DataError where its shader does not
  // compile.
  void draw(FrameContext& context, std::span<const Glow> glows) const;

 private:
  gl::VertexArray empty_;
};

}  // namespace skydrop::render
