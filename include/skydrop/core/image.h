// 8-bit RGBA pictures and PNG. Any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace skydrop::core {

// Row 0 is the top row; four bytes a pixel, sRGB-encoded colour, straight alpha.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;

  Image() = default;
  Image(int width, int height);

  std::uint8_t* pixel(int x, int y);
  const std::uint8_t* pixel(int x, int y) const;
};

// Throws DataError (naming `name` and the chunk) for what is not a PNG, is larger than 16384 a side or than
// 512 MiB of pixels, is cut off or damaged: the checksums of the chunks and of the pixels are compared. What
// follows the end chunk is ignored.
Image decodePng(std::span<const std::byte> bytes, std::string_view name);
std::vector<std::byte> encodePng(const Image& image);

Image readPng(const std::filesystem::path& path);
void writePng(const std::filesystem::path& path, const Image& image);  // atomically (file.h)

}  // namespace skydrop::core
