#include "skydrop/core/image.h"

#include <cstring>
#include <memory>
#include <string>

#include "core/png_check.h"
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

// Of stb_image, which does not always give one.
const char* failureReason() {
  const char* const reason = stbi_failure_reason();
  return reason != nullptr ? reason : "cannot be decoded";
}

constexpr int kMaxSide = 16384;
constexpr std::uint64_t kMostRowBytes = std::uint64_t{1} << 29;  // stb_image takes chunks of up to a gigabyte
constexpr std::uint64_t kMostDeflated = 1032;  // bytes that a byte of a deflate stream can stand for
constexpr const char* kCutOff = "are cut off: there are fewer than the header says";

std::size_t byteCount(int width, int height) {
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4;
}

void appendBytes(void* context, void* data, int size) {
  auto& bytes = *static_cast<std::vector<std::byte>*>(context);
  const auto* first = static_cast<const std::byte*>(data);
  bytes.insert(bytes.end(), first, first + size);
}

// Inflates the rows: stb_image neither compares their checksum nor minds if some are missing.
std::vector<std::byte> rowsOf(const PngContent& content, std::string_view name) {
  if (content.rowBytes > kMostRowBytes || content.compressed.size() > kMostRowBytes)
    throw DataError(name, "pixels", "too large");
  if (content.rowBytes / kMostDeflated > content.compressed.size()) throw DataError(name, "pixels", kCutOff);
  std::vector<std::byte> rows(content.rowBytes);
  const int inflated = stbi_zlib_decode_buffer(
      reinterpret_cast<char*>(rows.data()), static_cast<int>(rows.size()),
      reinterpret_cast<const char*>(content.compressed.data()), static_cast<int>(content.compressed.size()));
  if (inflated < 0) throw DataError(name, "pixels", failureReason());
  if (static_cast<std::size_t>(inflated) < rows.size()) throw DataError(name, "pixels", kCutOff);
  if (!matchesChecksum(rows, content.compressed)) throw DataError(name, "pixels", "their checksum is wrong");
  return rows;
}

}  // namespace

Image::Image(int w, int h) : width(w), height(h), rgba(byteCount(w, h)) {}

std::uint8_t* Image::pixel(int x, int y) { return rgba.data() + byteCount(width, y) + byteCount(x, 1); }
const std::uint8_t* Image::pixel(int x, int y) const {
  return rgba.data() + byteCount(width, y) + byteCount(x, 1);
}

Image decodePng(std::span<const std::byte> bytes, std::string_view name) {
  const PngContent content = checkPng(bytes, name);
  if (content.width < 1 || content.height < 1 || content.width > kMaxSide || content.height > kMaxSide) {
    throw DataError(name, "chunk IHDR",
                    "size " + std::to_string(content.width) + " x " + std::to_string(content.height) +
                        " is out of range");
  }
  int width = 0, height = 0, channels = 0;
  if (!stbi_info_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()), static_cast<int>(bytes.size()),
                             &width, &height, &channels)) {
    throw DataError(name, "chunk IHDR", failureReason());
  }
  // Inflated once, for the check: stb_image gets the rows as they are.
  const std::vector<std::byte> stored = withStoredRows(content, rowsOf(content, name));
  const auto* data = reinterpret_cast<const stbi_uc*>(stored.data());
  const int size = static_cast<int>(stored.size());
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load_from_memory(data, size, &width, &height, &channels, 4), stbi_image_free);
  if (!pixels) throw DataError(name, "pixels", failureReason());
  Image image(width, height);
  std::memcpy(image.rgba.data(), pixels.get(), image.rgba.size());
  return image;
}

std::vector<std::byte> encodePng(const Image& image, std::span<const PictureText> texts) {
  std::vector<std::byte> bytes;
  if (!stbi_write_png_to_func(appendBytes, &bytes, image.width, image.height, 4, image.rgba.data(),
                              image.width * 4)) {
    throw std::bad_alloc();  // the encoder's only failure
  }
  return texts.empty() ? bytes : withTexts(bytes, texts);
}

std::vector<PictureText> readPngTexts(std::span<const std::byte> bytes, std::string_view name) {
  return checkPng(bytes, name).texts;
}

Image readPng(const std::filesystem::path& path) { return decodePng(readFile(path), path.string()); }

void writePng(const std::filesystem::path& path, const Image& image, std::span<const PictureText> texts) {
  writeFileAtomically(path, encodePng(image, texts));
}

}  // namespace skydrop::core
