#include "skydrop/core/picture_file.h"

#include <turbojpeg.h>

#include <memory>
#include <new>
#include <string>

#include "core/jpeg_check.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"

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
  const std::unique_ptr<void, int (*)(tjhandle)> decoder(tjInitDecompress(), tjDestroy);
  if (!decoder) throw std::bad_alloc();
  Image image(size.width, size.height);
  // What libjpeg would only warn of is a picture that was made up in part.
  if (tjDecompress2(decoder.get(), reinterpret_cast<const unsigned char*>(bytes.data()),
                    static_cast<unsigned long>(bytes.size()), image.rgba.data(), size.width, 4 * size.width,
                    size.height, TJPF_RGBA,
                    TJFLAG_STOPONWARNING | TJFLAG_ACCURATEDCT | TJFLAG_LIMITSCANS) != 0)
    throw DataError(name, "pixels", tjGetErrorStr2(decoder.get()));
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
