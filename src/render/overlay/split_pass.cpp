#include "skydrop/render/overlay/split_pass.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace skydrop::render {
namespace {

bool isOfSize(const gl::Texture& texture, const View& view) {
  return texture && texture.width() == view.width && texture.height() == view.height;
}

}  // namespace

std::optional<std::string> SplitPass::skipReason(const FrameInput& frame) const {
  if (isOfSize(left_, frame.view) && isOfSize(right_, frame.view)) return std::nullopt;
  return "no pictures of this size are kept";
}

// A texture's first row is the lowest, a picture's the highest.
void SplitPass::upload(gl::Texture& texture, const core::Image& picture, std::string_view label) {
  if (!texture || texture.width() != picture.width || texture.height() != picture.height) {
    texture = gl::Texture::make2D(context_, GL_RGBA8, picture.width, picture.height, label);
  }
  const auto row = static_cast<std::ptrdiff_t>(picture.width) * 4;
  std::vector<std::uint8_t> bottomUp(picture.rgba.size());
  for (int y = 0; y < picture.height; ++y) {
    const auto from = picture.rgba.begin() + row * y;
    std::copy(from, from + row, bottomUp.begin() + row * (picture.height - 1 - y));
  }
  texture.upload(GL_RGBA, GL_UNSIGNED_BYTE, std::as_bytes(std::span(bottomUp)));
}

void SplitPass::draw(FrameContext& context) {
  context.gl.api().Disable(GL_DEPTH_TEST);
  left_.bind(0);
  right_.bind(1);
  gl::Shader& shader = context.shaders.shader("fullscreen.vert", "split/split.frag");
  shader.setFloat("dividerX", static_cast<float>(divider_ * context.frame.view.width));
  shader.use();
  triangle_.draw();
}

}  // namespace skydrop::render
