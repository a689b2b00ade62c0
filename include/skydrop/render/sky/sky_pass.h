#pragma once

#include "skydrop/render/frame/fullscreen_triangle.h"
#include "skydrop/render/frame/pass.h"

namespace skydrop::render {

// The sky with the sun's disc wherever nothing nearer was drawn, and below the horizon a plain of average
// land at sea level (shaders/sky/sky.glsl; the light is that of skydrop/sky/atmosphere.h, by
// FrameContext::uniforms alone). Never skipped. Reads and leaves the scene's depth as it is, writes its
// colour: linear light after exposure, bounded to what a half float holds. Publishes nothing, asks for
// nothing.
class SkyPass final : public Pass {
 public:
  // The context must outlive it.
  explicit SkyPass(gl::Context& context) : triangle_(context) {}

  std::string_view name() const override { return "sky"; }
  RenderStage stage() const override { return RenderStage::sky; }
  // Throws core::DataError where its shader does not compile.
  void draw(FrameContext& context) override;

 private:
  FullscreenTriangle triangle_;
};

}  // namespace skydrop::render
