// A target of their own for the passes of one stage, which is laid over the scene after the last of them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "skydrop/render/frame/pass.h"
#include "skydrop/render/frame/pixel_box.h"
#include "skydrop/render/frame/render_settings.h"
#include "skydrop/render/frame/render_stage.h"
#include "skydrop/render/frame/view.h"
#include "skydrop/render/gl/context.h"
#include "skydrop/render/gl/texture.h"

namespace skydrop::render {

// Which pixels of the scene are a layer's: a resource of the frame (FrameResources), published when the layer
// has been laid over it.
struct LayerCover {
  const gl::Texture* color = nullptr;  // four samples a texel, alpha 0 where the layer has nothing
  PixelBox box;                        // its first texel is the lower left pixel of this
};

// Main thread, on the context's thread. For each frame the renderer asks for skipReason(); where there is
// none it calls begin() before the first pass of the stage and compose() after the last.
class StageLayer {
 public:
  virtual ~StageLayer() = default;

  // As in the statistics, where composing has a row of its own: one word, lowerCamel.
  virtual std::string_view name() const = 0;
  // One whose target is the scene: terrain, sky or models.
  virtual RenderStage stage() const = 0;
  // Why the passes of this frame are drawn into the scene itself. `box`: the pixels that they may touch
  // (Pass::extent); always a reason where it is empty.
  virtual std::optional<std::string> skipReason(const RenderSettings& settings,
                                                const PixelBox& box) const = 0;
  // Clears the layer and makes it the target for what lies within `box`. Positions and viewport are those of
  // the whole picture, so shaders must not ask for gl_FragCoord.
  virtual void begin(gl::Context& context, const View& view, const PixelBox& box) = 0;
  // Lays it over the scene, whose buffer with colour and depth is bound, in the default state, and publishes
  // a LayerCover. Throws core::DataError (shader).
  virtual void compose(FrameContext& context) = 0;
};

}  // namespace skydrop::render
