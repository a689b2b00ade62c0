#pragma once

#include "skydrop/render/fog/ground_fog_settings.h"
#include "skydrop/render/frame/fullscreen_triangle.h"
#include "skydrop/render/frame/pass.h"

namespace skydrop::render {

// Lays fog over the scene's colour, by the scene's depth and the height of what lies between
// (shaders/shared/ground_fog.glsl has the formula, shaders/fog the light). Sun and sky light it as they light
// land, haze veils it, clouds in front of it hide it (CloudTransmittance). Drawn after clouds, so that it
// veils those behind it, and before the target's mark, whose lamp shines through. Publishes nothing.
class GroundFogPass final : public Pass {
 public:
  // The context must outlive it.
  GroundFogPass(gl::Context& context, const GroundFogSettings& settings)
      : settings_(settings), triangle_(context) {}

  // For the next frame. Costs nothing.
  void apply(const GroundFogSettings& settings) { settings_ = settings; }

  std::string_view name() const override { return "groundFog"; }
  RenderStage stage() const override { return RenderStage::translucents; }
  // Without density, and where no ray of the picture meets so much fog that a half float would show it.
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  // Throws core::DataError where its shader does not compile.
  void draw(FrameContext& context) override;

 private:
  GroundFogSettings settings_;
  FullscreenTriangle triangle_;
};

}  // namespace skydrop::render
