#pragma once

#include "skydrop/render/fullscreen_triangle.h"
#include "skydrop/render/pass.h"

namespace skydrop::render {

// The sky with the sun's disc wherever nothing nearer was drawn.
class SkyPass final : public Pass {
 public:
  explicit SkyPass(gl::Context& context) : triangle_(context) {}

  std::string_view name() const override { return "sky"; }
  Slot slot() const override { return Slot::sky; }
  void draw(FrameContext& context) override;

 private:
  FullscreenTriangle triangle_;
};

}  // namespace skydrop::render
