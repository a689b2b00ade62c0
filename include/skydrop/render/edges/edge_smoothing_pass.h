// Smooth edges of what is drawn with one sample a pixel: land, trees, houses, stones (docs/rendering.md).
#pragma once

#include "skydrop/render/frame/pass.h"
#include "skydrop/render/gl/buffer.h"
#include "skydrop/render/gl/texture.h"

namespace skydrop::render {

// Finds edges in the scene's depth and gives the pixels beside them what the other side has of them
// (shaders/shared/edge_steps.glsl), mixed as the screen shows it. The pixels of a stage's layer (LayerCover)
// stay as they are. After everything that is drawn into the scene. Holds 13 bytes a pixel of the scene, from
// the first frame that shows land. Publishes nothing.
class EdgeSmoothingPass final : public Pass {
 public:
  std::string_view name() const override { return "edges"; }
  RenderStage stage() const override { return RenderStage::edges; }
  std::optional<std::string> skipReasonAfter(const FrameInput& frame,
                                             const FrameResources& resources) const override;
  // Throws core::DataError where a shader does not compile.
  void draw(FrameContext& context) override;

 private:
  void resize(gl::Context& context, int width, int height);
  void mark(FrameContext& context);
  void clearLayer(FrameContext& context);
  void weigh(FrameContext& context);
  void blend(FrameContext& context);

  int width_ = 0, height_ = 0;  // of the scene, pixels
  gl::Texture words_;           // where depth steps, a bit each (shaders/edges/words.glsl)
  gl::Texture shares_;          // of each pixel (shaders/edges/shares.glsl)
  gl::Buffer listedWords_;      // those that hold steps
  gl::Buffer pixels_, lights_;  // those that have shares
};

}  // namespace skydrop::render
