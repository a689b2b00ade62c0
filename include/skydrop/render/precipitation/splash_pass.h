#pragma once

#include "skydrop/render/frame/pass.h"
#include "skydrop/render/gl/vertex_array.h"
#include "skydrop/render/precipitation/precipitation_settings.h"

namespace skydrop::render {

// Splashes of rain on the sea near the eye: rings that widen and drops that leap, hashed from cells of the
// water and spans of time; hidden by the scene. Publishes nothing.
class SplashPass final : public Pass {
 public:
  static constexpr double kRangeM = 18, kLifeS = 0.3;

  // The context must outlive it.
  SplashPass(gl::Context& context, const PrecipitationSettings& settings)
      : settings_(settings), empty_(context, "splashes") {}

  // For the next frame. Costs nothing.
  void apply(const PrecipitationSettings& settings) { settings_ = settings; }

  std::string_view name() const override { return "splashes"; }
  RenderStage stage() const override { return RenderStage::weatherEffects; }
  // Where no rain reaches the sea, and from more than kRangeM above it.
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  void draw(FrameContext& context) override;

 private:
  PrecipitationSettings settings_;
  gl::VertexArray empty_;
};

}  // namespace skydrop::render
