// Rain, snow and hail around the eye, as streaks.
#pragma once

#include "skydrop/render/frame/pass.h"
#include "skydrop/render/gl/buffer.h"
#include "skydrop/render/gl/vertex_array.h"
#include "skydrop/render/precipitation/precipitation_settings.h"

namespace skydrop::render {

// What falls at the eye (weather::fallAt() at its height, by the share of RainMap above it): a bounded number
// of streaks that the vertex shader hashes from cells of space and time (drop_sets.h), as long as the drops
// pass the eye while the shutter is open, lit by sun, sky and a SpotLight; hidden by the scene and by the
// cabin of the aircraft. Publishes nothing.
class PrecipitationPass final : public Pass {
 public:
  // The context must outlive it.
  PrecipitationPass(gl::Context& context, const PrecipitationSettings& settings);

  // For the next frame. Costs nothing.
  void apply(const PrecipitationSettings& settings) { settings_ = settings; }

  std::string_view name() const override { return "precipitation"; }
  RenderStage stage() const override { return RenderStage::weatherEffects; }
  // Where it is dry, above the cloud that feeds it, where all of it has evaporated.
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  // Below a gap of the clouds.
  std::optional<std::string> skipReasonAfter(const FrameInput& frame,
                                             const FrameResources& resources) const override;
  void draw(FrameContext& context) override;

 private:
  PrecipitationSettings settings_;
  gl::Buffer uniforms_, indices_;
  gl::VertexArray quads_;  // corners without buffers
};

}  // namespace skydrop::render
