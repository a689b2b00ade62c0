// Reads the scene's light before the tone map sees it.
#pragma once

#include <glm/vec4.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "skydrop/render/frame/pass.h"

namespace skydrop::test {

// After a frame `light` holds the scene's colour, bottom row first.
class LightProbe final : public render::Pass {
 public:
  explicit LightProbe(std::vector<glm::vec4>& light) : light_(light) {}
  std::string_view name() const override { return "probe"; }
  render::RenderStage stage() const override { return render::RenderStage::toneMap; }
  void draw(render::FrameContext& context) override {
    light_.resize(static_cast<std::size_t>(context.sceneColor.width() * context.sceneColor.height()));
    context.sceneColor.read(GL_RGBA, GL_FLOAT, std::as_writable_bytes(std::span(light_)));
  }

 private:
  std::vector<glm::vec4>& light_;
};

}  // namespace skydrop::test
