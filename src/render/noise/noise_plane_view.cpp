#include "skydrop/render/noise/noise_plane_view.h"

namespace skydrop::render {

void NoisePlaneView::show(int width, int height, std::span<const std::byte> values, Look look) {
  if (!picture_ || picture_.width() != width || picture_.height() != height) {
    picture_ = gl::Texture::make2D(context_, GL_R8, width, height, "noise plane");
    picture_.setWrap(GL_REPEAT);
  }
  const bool grey = look == Look::grey;
  const auto take = [&](GLenum channel, GLint from) {
    context_.api().TextureParameteri(picture_.id(), channel, from);
  };
  for (const GLenum channel : {GL_TEXTURE_SWIZZLE_R, GL_TEXTURE_SWIZZLE_G, GL_TEXTURE_SWIZZLE_B})
    take(channel, grey ? GL_RED : GL_ONE);
  take(GL_TEXTURE_SWIZZLE_A, grey ? GL_ONE : GL_RED);
  picture_.upload(GL_RED, GL_UNSIGNED_BYTE, values);
}

}  // namespace skydrop::render
