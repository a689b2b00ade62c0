#pragma once

#include "skydrop/render/frame/fullscreen_triangle.h"
#include "skydrop/render/frame/pass.h"
#include "skydrop/render/gl/texture.h"
#include "skydrop/render/sky/rainbow_settings.h"

namespace skydrop::render {

// Adds the primary and the secondary rainbow, and what else of the light of sun or moon rain sends back
// within 90 degrees of the antisolar point (shaders/sky/rainbow.glsl), up to the scene's depth: before land,
// sky and the clouds behind, while clouds in front hide it (CloudTransmittance). Rain dims nothing here.
// Publishes nothing.
class RainbowPass final : public Pass {
 public:
  // Reads its table from assets/optics; throws core::DataError where it is not what
  // assets/scripts/make_rainbow.py writes. The context must outlive it.
  RainbowPass(gl::Context& context, const RainbowSettings& settings);

  // For the next frame. Costs nothing.
  void apply(const RainbowSettings& settings) { settings_ = settings; }

  std::string_view name() const override { return "rainbow"; }
  RenderStage stage() const override { return RenderStage::translucents; }
  // Without rain, with the light below the horizon, with no ray of the picture within 90 degrees of the
  // antisolar point, and from above the rain where all rays rise.
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  // Throws core::DataError where its shader does not compile.
  void draw(FrameContext& context) override;

 private:
  // The settings, and with weather how dense and high the rain is halfway through them, opposite the light.
  RainbowSettings rainOf(const FrameInput& frame) const;

  RainbowSettings settings_;
  FullscreenTriangle triangle_;
  gl::Texture table_;
};

}  // namespace skydrop::render
