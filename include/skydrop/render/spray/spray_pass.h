// Dust, smoke, drops and mist of the snapshot's bursts (game/surface_burst.h).
#pragma once

#include <cstddef>

#include "skydrop/render/frame/pass.h"
#include "skydrop/render/gl/vertex_array.h"
#include "skydrop/render/spray/dust_and_spray_settings.h"

namespace skydrop::render {

// Particles are hashed from the burst, their number and the time: nothing of them is kept, on the GPU or
// beside it, so a frame is the same whenever it is drawn. Lit by sun and sky as models are, soft where they
// meet the scene, veiled by clouds; they throw no shadow and write no depth. Publishes nothing.
class SprayPass final : public Pass {
 public:
  // In a frame at most so many times DustAndSpraySettings::particles: the newest bursts have theirs first.
  static constexpr int kMostFull = 24;

  // The context must outlive it.
  SprayPass(gl::Context& context, const DustAndSpraySettings& settings)
      : settings_(settings), empty_(context, "dust and spray") {}

  // For the next frame. Costs nothing.
  void apply(const DustAndSpraySettings& settings) { settings_ = settings; }

  std::string_view name() const override { return "spray"; }
  RenderStage stage() const override { return RenderStage::translucents; }
  // Where nothing has been thrown up, or none of it is near and in view.
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  void draw(FrameContext& context) override;

  // Of the last frame that was drawn, for tests.
  std::size_t particlesDrawn() const { return particlesDrawn_; }

 private:
  DustAndSpraySettings settings_;
  gl::VertexArray empty_;
  std::size_t particlesDrawn_ = 0;
};

}  // namespace skydrop::render
