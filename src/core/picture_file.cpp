#include "skydrop/core/picture_file.h"

#include <cstring>
#include <memory>
#include <string>

#include "core/jpeg_check.h"
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
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#include <stb_image.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace skydrop::core {
namespace {

constexpr int kMaxSide = 16384;
constexpr std::size_t kMostPixels = (std::size_t{512} << 20) / 4, kMostBytes = std::size_t{256} << 20;

// A file of fewer bytes cannot hold the picture. A block of 64 pixels has two codes of a bit at least; one
// code of a progressive scan leaves out up to 32767 blocks.
constexpr std::size_t kMostPixelsAByte = 8 / 2 * 64, kMostPixelsAByteInScans = std::size_t{8} * 64 * 32767;

}  // namespace

Image decodeJpeg(std::span<const std::byte> bytes, std::string_view name) {
  const JpegSize size = checkJpeg(bytes, name);
  const auto pixelCount = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  if (size.width < 1 || size.height < 1 || size.width > kMaxSide || size.height > kMaxSide ||
      pixelCount > kMostPixels)
    throw DataError(name, "size",
                    std::to_string(size.width) + " x " + std::to_string(size.height) + " is out of range");
  if (bytes.size() > kMostBytes) throw DataError(name, "", "is larger than 256 MiB");
  if (pixelCount / (size.isProgressive ? kMostPixelsAByteInScans : kMostPixelsAByte) > bytes.size())
    throw DataError(name, "", "is cut off");
  int width = 0, height = 0, channels = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()), static_cast<int>(bytes.size()),
                            &width, &height, &channels, 4),
      stbi_image_free);
  if (!pixels) {
    const char* const reason =
        stbi_failure_reason();  // null where it gives none, or the last one that it gave
    throw DataError(name, "pixels", reason != nullptr ? reason : "cannot be decoded");
  }
  Image image(width, height);
  std::memcpy(image.rgba.data(), pixels.get(), image.rgba.size());
  return image;
}

Image decodePicture(std::span<const std::byte> bytes, std::string_view name) {
  if (bytes.size() >= 2 && bytes[0] == std::byte{0xff} && bytes[1] == std::byte{0xd8})
    return decodeJpeg(bytes, name);
  if (bytes.size() >= 2 && bytes[0] == std::byte{0x89} && bytes[1] == std::byte{'P'})
    return decodePng(bytes, name);
  throw DataError(name, "", "is neither PNG nor JPEG");
}

Image readPicture(const std::filesystem::path& path) { return decodePicture(readFile(path), path.string()); }

}  // namespace skydrop::core
