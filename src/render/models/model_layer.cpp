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

PixelBox unite(const PixelBox& a, const PixelBox& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.lowX, b.lowX), std::min(a.lowY, b.lowY), std::max(a.highX, b.highX),
          std::max(a.highY, b.highY)};
}

bool ModelLayer::begin(gl::Context& context, const PixelBox& box, int pictureWidth, int pictureHeight) {
  const int width = std::max(target_ ? target_.width() : 0, roundedUp(box.width()));
  const int height = std::max(target_ ? target_.height() : 0, roundedUp(box.height()));
  if (width * height > kMostPixels) return false;
  if (!target_) {
    target_ = gl::FrameBuffer(context, width, height, kFormat, "models");
    triangle_.emplace(context);
  }
  target_.resize(width, height);
  box_ = box;
  target_.bind(gl::FrameBuffer::Clear::yes);
  context.api().Viewport(-box.lowX, -box.lowY, pictureWidth, pictureHeight);
  return true;
}

void ModelLayer::compose(gl::Context& context, gl::ShaderCache& shaders) {
  const gl::Functions& api = context.api();
  gl::Shader& shader = shaders.shader("fullscreen.vert", "models/layer.frag");
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
