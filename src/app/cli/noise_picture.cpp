#include "app/cli/noise_picture.h"

#include <cstdio>

#include "skydrop/core/error.h"

namespace skydrop::app {

core::Image pictureOf(const core::TextureData& texture, int layer) {
  using core::TexelFormat;
  core::Image image(texture.width, texture.height);
  const std::size_t pixels = image.rgba.size() / 4, bytes = pixels * core::texelBytes(texture.format);
  const std::byte* first = texture.texels.data() + static_cast<std::size_t>(layer) * bytes;
  const auto byteAt = [first](std::size_t i) { return std::to_integer<std::uint8_t>(first[i]); };
  for (std::size_t i = 0; i < pixels; ++i) {
    std::uint8_t* rgba = image.rgba.data() + i * 4;
    switch (texture.format) {
      case TexelFormat::rgba8:
        for (std::size_t c = 0; c < 3; ++c) rgba[c] = byteAt(i * 4 + c);
        rgba[3] = 255;
        break;
      case TexelFormat::r8:
        rgba[0] = rgba[1] = rgba[2] = byteAt(i);
        rgba[3] = 255;
        break;
      case TexelFormat::a8:
        rgba[0] = rgba[1] = rgba[2] = 255;
        rgba[3] = byteAt(i);
        break;
      default:
        throw core::RangeError("a texture of format " + std::string(core::texelFormatName(texture.format)) +
                               " cannot be written as PNG: only rgba8, r8 and a8 can");
    }
  }
  return image;
}

std::string layerFile(const std::string& file, const core::TextureData& texture, int layer) {
  if (!texture.isVolume()) return file;
  char number[24];
  std::snprintf(number, sizeof number, "-%03d.png", layer);
  return file.substr(0, file.size() - 4) + number;
}

}  // namespace skydrop::app
