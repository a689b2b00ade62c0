#include "skydrop/core/image.h"

#include <cstring>
#include <memory>

#include "skydrop/core/error.h"
#include "skydrop/core/file.h"

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#include <stb_image.h>
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb_image_write.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace skydrop::core {
namespace {

constexpr int kMaxSide = 16384;

std::size_t byteCount(int width, int height) {
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4;
}

void appendBytes(void* context, void* data, int size) {
  auto& bytes = *static_cast<std::vector<std::byte>*>(context);
  const auto* first = static_cast<const std::byte*>(data);
  bytes.insert(bytes.end(), first, first + size);
}

}  // namespace

Image::Image(int w, int h) : width(w), height(h), rgba(byteCount(w, h)) {}

std::uint8_t* Image::pixel(int x, int y) { return rgba.data() + byteCount(width, y) + byteCount(x, 1); }
const std::uint8_t* Image::pixel(int x, int y) const {
  return rgba.data() + byteCount(width, y) + byteCount(x, 1);
}

Image decodePng(std::span<const std::byte> bytes, std::string_view name) {
  static constexpr unsigned char kMagic[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  if (bytes.size() < sizeof kMagic || std::memcmp(bytes.data(), kMagic, sizeof kMagic) != 0) {
    throw DataError(name, "signature", "not a PNG file");
  }
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int size = static_cast<int>(bytes.size());
  int width = 0, height = 0, channels = 0;
  if (!stbi_info_from_memory(data, size, &width, &height, &channels)) {
    throw DataError(name, "header", stbi_failure_reason());
  }
  if (width < 1 || height < 1 || width > kMaxSide || height > kMaxSide) {
    throw DataError(name, "header",
                    "size " + std::to_string(width) + " x " + std::to_string(height) + " is out of range");
  }
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load_from_memory(data, size, &width, &height, &channels, 4), stbi_image_free);
  if (!pixels) throw DataError(name, "pixels", stbi_failure_reason());
  Image image(width, height);
  std::memcpy(image.rgba.data(), pixels.get(), image.rgba.size());
  return image;
}

std::vector<std::byte> encodePng(const Image& image) {
  std::vector<std::byte> bytes;
  if (!stbi_write_png_to_func(appendBytes, &bytes, image.width, image.height, 4, image.rgba.data(),
                              image.width * 4)) {
    throw std::bad_alloc();  // the encoder's only failure
  }
  return bytes;
}

Image readPng(const std::filesystem::path& path) { return decodePng(readFile(path), path.string()); }

void writePng(const std::filesystem::path& path, const Image& image) {
  writeFileAtomically(path, encodePng(image));
}

}  // namespace skydrop::core
