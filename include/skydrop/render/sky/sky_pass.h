#pragma once

#include "skydrop/render/frame/fullscreen_triangle.h"
#include "skydrop/render/frame/pass.h"

namespace skydrop::render {

// The sky with the sun's disc wherever nothing nearer was drawn.
class SkyPass final : public Pass {
 public:
  explicit SkyPass(gl::Context& context) : triangle_(context) {}

  std::string_view name() const override { return "sky"; }
  RenderStage stage() const override { return RenderStage::sky; }
  void draw(FrameContext& context) override;

 private:
  FullscreenTriangle triangle_;
};

}  // namespace skydrop::render
