// 8-bit RGBA pictures and PNG. Any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
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

// What a file says about its picture.
struct PictureText {
  std::string keyword, text;

  bool operator==(const PictureText&) const = default;
};

// Throws DataError (naming `name` and the chunk) for what is not a PNG, is larger than 16384 a side or than
// 512 MiB of pixels, is cut off or damaged: the checksums of the chunks and of the pixels are compared. What
// follows the end chunk is ignored.
Image decodePng(std::span<const std::byte> bytes, std::string_view name);
// With `texts` before the pixels, as iTXt chunks: of each a keyword of 1 to 79 printable ASCII characters,
// and UTF-8.
std::vector<std::byte> encodePng(const Image& image, std::span<const PictureText> texts = {});

// The texts of a PNG in their order; compressed ones are left out. Throws as decodePng() does, but looks at
// no pixels.
std::vector<PictureText> readPngTexts(std::span<const std::byte> bytes, std::string_view name);

Image readPng(const std::filesystem::path& path);
// Atomically (file.h).
void writePng(const std::filesystem::path& path, const Image& image, std::span<const PictureText> texts = {});

}  // namespace skydrop::core
