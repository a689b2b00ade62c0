#pragma once

#include <glm/vec3.hpp>

#include "skydrop/render/frame/pass.h"
#include "skydrop/render/gl/vertex_array.h"

namespace skydrop::render {

// Where the moon hides what is behind it: published by MoonPass for the passes of the sky after it.
struct MoonDisc {
  glm::dvec3 direction{0, 1, 0};  // unit, as it appears
  double radiusRad = 0;
};

// The moon's disc (shaders/sky/moon.glsl) at the place and time of the settings' clock: lit by where the sun
// stands, with its seas, in the earth's light on the dark side, dimmed by the air; by day before the blue of
// the sky, which lies in front of it. Its brightest parts are shown no brighter than kBrightestShown after
// exposure, so that the seas can be seen at night, to which the frame as a whole is exposed.
class MoonPass final : public Pass {
 public:
  static constexpr double kBrightestShown = 2.5;

  // The context must outlive it.
  MoonPass(gl::Context& context, const SunSettings& clock);

  // For the next frame. Costs nothing.
  void apply(const SunSettings& clock) { clock_ = clock; }

  std::string_view name() const override { return "moon"; }
  RenderStage stage() const override { return RenderStage::sky; }
  // With a sun that is set by hand, and with the moon below the horizon or out of view.
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  // Throws core::DataError where its shader does not compile.
  void draw(FrameContext& context) override;

 private:
  SunSettings clock_;
  MoonDisc disc_;          // published
  gl::VertexArray array_;  // without vertices
};

}  // namespace skydrop::render
