// Shafts of light: takes from the scene what the air between would scatter if clouds and land did not hide
// the sun from it (docs/light-shafts.md). A march in a reduced picture, a filter over its steps' places, and
// a composition that follows the scene's outlines. Sources: Max, "Atmospheric Illumination and Shadows",
// 1986 (the integral); Toth and Umenhoffer, "Real-time Volumetric Lighting in Participating Media", 2009
// (interleaved steps).
#pragma once

#include <glm/vec2.hpp>

#include "skydrop/render/frame/pass.h"
#include "skydrop/render/shadows/land_shade_volume.h"
#include "skydrop/render/shafts/light_shaft_settings.h"

namespace skydrop::render {

class CloudShadowMap;

// Drawn after clouds, which hide what lies behind them, and before fog. Reads CloudShadowMap, LandShadowMap
// and CloudTransmittance of the frame; without either of the first two there is nothing to do. Publishes
// nothing. On the context's thread.
class LightShaftPass final : public Pass {
 public:
  explicit LightShaftPass(const LightShaftSettings& settings) : settings_(settings) {}

  // For the next frame. Costs nothing.
  void apply(const LightShaftSettings& settings) { settings_ = settings; }

  std::string_view name() const override { return "lightShafts"; }
  RenderStage stage() const override { return RenderStage::translucents; }
  // Without haze, and while the sun lights no air.
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  // Where nothing shades the air, and for views above all shade.
  std::optional<std::string> skipReasonAfter(const FrameInput& frame,
                                             const FrameResources& resources) const override;
  // Only where neither gave a reason. Throws core::DataError where a shader does not compile.
  void draw(FrameContext& context) override;

 private:
  // What shades the air of a frame; null: nothing of that kind.
  struct Shade {
    const CloudShadowMap* clouds = nullptr;
    const LandShadowMap* land = nullptr;
  };

  static Shade shadeOf(const FrameInput& frame, const FrameResources& resources);
  // Of all that shades, in the world, m.
  double topM(const FrameInput& frame, const Shade& shade) const;
  void resize(FrameContext& context);
  void march(FrameContext& context, const Shade& shade);
  void setScene(gl::ShaderProgram& shader, double topM) const;
  void compose(FrameContext& context, const Shade& shade);

  LightShaftSettings settings_;
  LandShadeVolume land_;
  // RGBA16F: light that is lost by the opacity of the air, and that opacity.
  gl::Texture marched_, filtered_;
};

}  // namespace skydrop::render
