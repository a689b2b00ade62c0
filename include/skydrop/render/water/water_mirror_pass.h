// What stands above the sea as calm water would mirror it: a picture from the eye's mirror image, through
// whose depths WaterReflectionPass follows the rays of waves (docs/water.md).
#pragma once

#include "skydrop/render/frame/pass.h"
#include "skydrop/render/gl/frame_buffer.h"
#include "skydrop/render/water/water_detail_settings.h"

namespace skydrop::render {

// That picture: linear light (RGBA16F) and reversed depth (D32F, 0 where it shows nothing) of a view of the
// mirrored eye. A resource of the frame (FrameResources).
struct MirroredScene {
  const gl::Texture* light = nullptr;
  const gl::Texture* depth = nullptr;
  View view{};
};

// Publishes MirroredScene where the settings ask for it: land, trees, houses, ground cover, aircraft and
// packages are drawn a second time (Pass::isMirrored). It has neither sky, which the sea is drawn with, nor
// what is translucent. Without the setting it holds and draws nothing.
class WaterMirrorPass final : public Pass {
 public:
  explicit WaterMirrorPass(const WaterDetailSettings& settings) : settings_(settings) {}

  // For the next frame.
  void apply(const WaterDetailSettings& settings);

  std::string_view name() const override { return "waterMirror"; }
  RenderStage stage() const override { return RenderStage::mirrors; }
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  std::optional<View> alsoShows(const View& view) const override;
  void draw(FrameContext& context) override;

 private:
  bool isAsked() const;

  WaterDetailSettings settings_;
  gl::FrameBuffer picture_, land_;  // land_: LandSurface
  MirroredScene mirrored_;          // published
};

}  // namespace skydrop::render
