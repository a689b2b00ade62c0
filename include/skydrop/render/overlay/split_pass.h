#pragma once

#include "skydrop/core/image.h"
#include "skydrop/render/frame/fullscreen_triangle.h"
#include "skydrop/render/frame/pass.h"
#include "skydrop/render/gl/texture.h"

namespace skydrop::render {

// Shows two kept pictures side by side in place of the frame's own, with a thin line between them: below the
// interface, over whatever else was drawn into the output. Alpha of the pictures is ignored. Publishes
// nothing, asks for nothing.
class SplitPass final : public Pass {
 public:
  // The context must outlive it.
  explicit SplitPass(gl::Context& context) : context_(context), triangle_(context) {}

  std::string_view name() const override { return "split"; }
  RenderStage stage() const override { return RenderStage::hud; }
  // It waits for both pictures, in the size of the frame.
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  // Throws core::DataError where its shader does not compile.
  void draw(FrameContext& context) override;

  // From the next frame on.
  void setLeft(const core::Image& picture) { upload(left_, picture, "split left"); }
  void setRight(const core::Image& picture) { upload(right_, picture, "split right"); }
  // Of the width, [0, 1].
  void setDivider(double divider) { divider_ = divider; }
  // Waits for pictures again.
  void forget() { left_ = {}, right_ = {}; }

 private:
  void upload(gl::Texture& texture, const core::Image& picture, std::string_view label);

  gl::Context& context_;
  FullscreenTriangle triangle_;
  gl::Texture left_, right_;
  double divider_ = 0.5;
};

}  // namespace skydrop::render
