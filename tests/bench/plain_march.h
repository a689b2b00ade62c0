// The march of the thesis, the baseline of the clouds' times: 128 steps a ray, each with six samples towards
// the sun, a ray a pixel, nothing skipped.
#pragma once

#include <optional>

#include "skydrop/render/frame/pass.h"
#include "skydrop/render/gl/texture.h"

namespace skydrop::bench {

// Runs after a render::CloudSystem of the same frame and reads what that left bound: noise, depth and
// uniforms of the medium. Its light stays in a texture of its own, so it costs no more than the march.
class PlainMarch final : public render::Pass {
 public:
  // Only frames that ask for it have it.
  bool asked = false;

  // A texel a pixel, of the last frame that asked: radiance, and the share of light behind that comes
  // through.
  const render::gl::Texture& light() const { return light_; }

  std::string_view name() const override { return "plainMarch"; }
  render::RenderStage stage() const override { return render::RenderStage::clouds; }
  std::optional<std::string> skipReason(const render::FrameInput& frame) const override;
  void draw(render::FrameContext& context) override;

 private:
  render::gl::Texture light_;
};

}  // namespace skydrop::bench
