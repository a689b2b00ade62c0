#include "skydrop/render/models/model_layer.h"

#include <algorithm>
#include <glm/vec2.hpp>

namespace skydrop::render {
namespace {

constexpr gl::FrameBufferFormat kFormat{GL_RGBA16F, GL_DEPTH_COMPONENT32F, 4};
constexpr GLuint kColorUnit = 0, kDepthUnit = 1;  // as in shaders/models/layer.glsl
constexpr int kGrowth = 64;  // pixels: a turning aircraft must not make a new layer in each frame

int roundedUp(int size) { return (size + kGrowth - 1) / kGrowth * kGrowth; }

}  // namespace

int ModelLayer::widthFor(const PixelBox& box) const {
  return std::max(target_ ? target_.width() : 0, roundedUp(box.width()));
}

int ModelLayer::heightFor(const PixelBox& box) const {
  return std::max(target_ ? target_.height() : 0, roundedUp(box.height()));
}

std::optional<std::string> ModelLayer::skipReason(const RenderSettings& settings, const PixelBox& box) const {
  if (!settings.smoothModels) return "switched off";
  if (box.empty()) return "no model in view";
  if (widthFor(box) * heightFor(box) > kMostPixels) return "the models cover too many pixels";
  return std::nullopt;
}

void ModelLayer::begin(gl::Context& context, const View& view, const PixelBox& box) {
  const int width = widthFor(box), height = heightFor(box);
  if (!target_) {
    target_ = gl::FrameBuffer(context, width, height, kFormat, "models");
    triangle_.emplace(context);
  }
  target_.resize(width, height);
  box_ = box;
  target_.bind(gl::FrameBuffer::Clear::yes);
  context.api().Viewport(-box.lowX, -box.lowY, view.width, view.height);
}

void ModelLayer::compose(FrameContext& context) {
  const gl::Functions& api = context.gl.api();
  cover_ = {&target_.colorTexture(), box_};
  context.resources.publish(cover_);
  gl::Shader& shader = context.shaders.shader("fullscreen.vert", "models/layer.frag");
  shader.use();
  shader.setIvec2("layerLow", glm::ivec2(box_.lowX, box_.lowY));
  target_.colorTexture().bind(kColorUnit);
  target_.depthTexture().bind(kDepthUnit);
  api.Enable(GL_SCISSOR_TEST);
  api.Scissor(box_.lowX, box_.lowY, box_.width(), box_.height());
  api.Enable(GL_BLEND);
  api.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  triangle_->draw();
}

}  // namespace skydrop::render
