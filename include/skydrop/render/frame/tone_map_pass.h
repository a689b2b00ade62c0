#pragma once

#include "skydrop/render/frame/fullscreen_triangle.h"
#include "skydrop/render/frame/pass.h"

namespace skydrop::render {

// Scene light to encoded 8-bit colour; without it the output stays black.
class ToneMapPass final : public Pass {
 public:
  explicit ToneMapPass(gl::Context& context) : triangle_(context) {}

  std::string_view name() const override { return "toneMap"; }
  RenderStage stage() const override { return RenderStage::toneMap; }
  void draw(FrameContext& context) override;

 private:
  FullscreenTriangle triangle_;
};

}  // namespace skydrop::render
