// Rain and snow seen from afar: the haze of what falls around the eye, and shafts below distant clouds.
#pragma once

#include "skydrop/render/frame/pass.h"
#include "skydrop/render/gl/buffer.h"
#include "skydrop/render/gl/vertex_array.h"
#include "skydrop/render/precipitation/precipitation_settings.h"

namespace skydrop::render {

// A veil over the scene. At the corners of a coarse grid over the picture the vertex shader marches through
// what falls (shared/precipitation.glsl): optical depth up to four distances, and light; each pixel takes the
// depth up to what it shows, so edges of land and aircraft stay sharp. Where a RainMap is published it hangs
// below those clouds and leans with the wind; lit by what clouds leave (CloudShadowMap), behind clouds that
// are nearer (CloudTransmittance). Publishes nothing.
class RainVeilPass final : public Pass {
 public:
  // The context must outlive it.
  RainVeilPass(gl::Context& context, const PrecipitationSettings& settings);

  // For the next frame. Makes the grid again where its columns changed.
  void apply(const PrecipitationSettings& settings);

  std::string_view name() const override { return "rainVeil"; }
  RenderStage stage() const override { return RenderStage::translucents; }
  // Where it is dry, and from above the cloud where all rays rise.
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  void draw(FrameContext& context) override;

 private:
  struct Variant;
  void makeGrid();
  gl::Shader& shaderOf(FrameContext& context, const Variant& variant) const;

  gl::Context& context_;
  PrecipitationSettings settings_;
  int columns_ = 0, rows_ = 0;
  gl::Buffer indices_;
  gl::VertexArray grid_;  // corners without buffers
};

}  // namespace skydrop::render
