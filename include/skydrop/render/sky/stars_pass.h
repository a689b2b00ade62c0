#pragma once

#include <span>

#include "skydrop/render/frame/pass.h"
#include "skydrop/render/gl/buffer.h"
#include "skydrop/render/gl/vertex_array.h"
#include "skydrop/render/sky/stars_settings.h"
#include "skydrop/sky/stars.h"

namespace skydrop::render {

// Stars as points on the sky (shaders/sky/stars.glsl): turned by the sidereal time of the settings' clock and
// place, raised by refraction, dimmed by the air. Each sends the light of its magnitude, spread over some
// pixels so that it neither flickers nor jumps as it moves across them. The moon (MoonDisc) hides those
// behind it.
class StarsPass final : public Pass {
 public:
  // The stars in the order of their magnitude, the brightest first (sky::readStars). The context must outlive
  // it.
  StarsPass(gl::Context& context, std::span<const sky::Star> stars, const StarsSettings& settings);

  // For the next frame. Costs nothing.
  void apply(const StarsSettings& settings);

  std::string_view name() const override { return "stars"; }
  RenderStage stage() const override { return RenderStage::sky; }
  // While the sun is up, and where none is drawn.
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  // Throws core::DataError where its shader does not compile.
  void draw(FrameContext& context) override;

 private:
  StarsSettings settings_;
  std::vector<float> magnitudes_;  // in their order
  gl::Buffer vertices_;
  gl::VertexArray array_;
};

}  // namespace skydrop::render
