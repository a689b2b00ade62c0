// Models with smooth edges: they are drawn into a layer of their own with four samples a pixel, as large as
// the part of the picture that they cover, and laid over the scene by coverage and depth. Land and sky need
// no such thing and do not pay for it.
#pragma once

#include <optional>

#include "skydrop/render/frame/fullscreen_triangle.h"
#include "skydrop/render/frame/stage_layer.h"
#include "skydrop/render/gl/frame_buffer.h"

namespace skydrop::render {

// Holds no GL object before the first frame that shows a model. Skipped where RenderSettings::smoothModels is
// off, where no model is in view, and where the models cover so much that it would have to grow beyond
// kMostPixels.
class ModelLayer final : public StageLayer {
 public:
  static constexpr int kMostPixels = 1 << 20;  // 48 MiB

  std::string_view name() const override { return "modelLayer"; }
  RenderStage stage() const override { return RenderStage::models; }
  std::optional<std::string> skipReason(const RenderSettings& settings, const PixelBox& box) const override;
  void begin(gl::Context& context, const View& view, const PixelBox& box) override;
  void compose(FrameContext& context) override;

 private:
  // At least as large as it was.
  int widthFor(const PixelBox& box) const;
  int heightFor(const PixelBox& box) const;

  gl::FrameBuffer target_;
  std::optional<FullscreenTriangle> triangle_;
  PixelBox box_;
  LayerCover cover_;  // published
};

}  // namespace skydrop::render
