// Rings, foam and wakes on the sea of the snapshot's bursts (game/surface_burst.h).
#pragma once

#include <cstddef>

#include "skydrop/render/frame/pass.h"
#include "skydrop/render/gl/vertex_array.h"
#include "skydrop/render/spray/dust_and_spray_settings.h"

namespace skydrop::render {

// One quadrangle on the sea round all bursts on water: each makes the waves of a body that falls into deep
// water (shared::impactWaveSlope), whose sum behind a hull is its wake, and foam that spreads and fades. The
// waves tilt a level sea; the picture is multiplied by what that makes of its light, so the waves of the wind
// stay. Publishes nothing.
class WakePass final : public Pass {
 public:
  static constexpr std::size_t kMostWakes = 24;  // as in shaders/spray/wake_look.glsl; the newest

  // The context must outlive it.
  WakePass(gl::Context& context, const DustAndSpraySettings& settings)
      : settings_(settings), empty_(context, "wakes") {}

  // For the next frame. Costs nothing.
  void apply(const DustAndSpraySettings& settings) { settings_ = settings; }

  std::string_view name() const override { return "wakes"; }
  RenderStage stage() const override { return RenderStage::translucents; }
  // Where nothing has touched water, or none of it is near and in view.
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  void draw(FrameContext& context) override;

 private:
  DustAndSpraySettings settings_;
  gl::VertexArray empty_;
};

}  // namespace skydrop::render
