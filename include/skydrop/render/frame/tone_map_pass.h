#pragma once

#include "skydrop/render/frame/fullscreen_triangle.h"
#include "skydrop/render/frame/pass.h"

namespace skydrop::render {

// The scene's linear light (FrameContext::sceneColor, [0, 65504] after exposure; less counts as 0) to the
// output: tone curve (Hill 2015, shaders/shared/tone_map.glsl), sRGB encoding (IEC 61966-2-1) and dither, 8
// bits a channel, alpha 1. With RenderSettings::guardMarks it marks where light was cut, negative or no
// number (shaders/shared/guard_marks.glsl). Never skipped; without this pass the output stays black. It
// overwrites every pixel, so the interface comes after it. Publishes nothing, asks for nothing.
class ToneMapPass final : public Pass {
 public:
  // The context must outlive it.
  explicit ToneMapPass(gl::Context& context) : triangle_(context) {}

  std::string_view name() const override { return "toneMap"; }
  RenderStage stage() const override { return RenderStage::toneMap; }
  // Throws core::DataError where its shader does not compile.
  void draw(FrameContext& context) override;

 private:
  FullscreenTriangle triangle_;
};

}  // namespace skydrop::render
