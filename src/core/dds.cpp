#include "skydrop/core/dds.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstdint>
#include <cstring>
#include <string>

#include "skydrop/core/error.h"
#include "skydrop/core/file.h"

namespace skydrop::core {
namespace {

using Word = std::uint32_t;

constexpr int kMaxSide2D = 16384, kMaxSide3D = 2048;  // what OpenGL 4.5 promises of textures and volumes
constexpr std::uint64_t kMaxBytes = std::uint64_t{256} << 20;

constexpr std::size_t kLegacyWords = 32;  // the magic number and DDS_HEADER
constexpr std::size_t kDx10Words = 5;     // DDS_HEADER_DXT10

// Places of the fields, in words from the start of the file.
enum Field : std::size_t {
  kMagic = 0,
  kHeaderSize = 1,
  kFlags = 2,
  kHeight = 3,
  kWidth = 4,
  kPitch = 5,
  kDepth = 6,
  kMipCount = 7,
  kPixelSize = 19,
  kPixelFlags = 20,
  kFourCc = 21,
  kBitCount = 22,
  kRedMask = 23,
  kGreenMask = 24,
  kBlueMask = 25,
  kAlphaMask = 26,
  kCaps = 27,
  kCaps2 = 28,
  kDxgiFormat = 32,
  kDimension = 33,
  kMisc = 34,
  kArraySize = 35
};

constexpr Word fourCc(const char (&letters)[5]) {
  Word code = 0;
  for (std::size_t i = 4; i-- > 0;) code = code << 8 | static_cast<unsigned char>(letters[i]);
  return code;
}

constexpr Word kDds = fourCc("DDS "), kDx10 = fourCc("DX10");
constexpr Word kFlagCaps = 0x1, kFlagHeight = 0x2, kFlagWidth = 0x4, kFlagPitch = 0x8,
               kFlagPixelFormat = 0x1000, kFlagDepth = 0x800000;
constexpr Word kCapsComplex = 0x8, kCapsTexture = 0x1000, kCaps2Cube = 0x200, kCaps2Volume = 0x200000;
constexpr Word kPixelAlpha = 0x1, kPixelAlphaAlone = 0x2, kPixelFourCc = 0x4, kPixelRgb = 0x40,
               kPixelLuminance = 0x20000;
constexpr Word kDimension2D = 3, kDimension3D = 4, kMiscCube = 0x4;

struct PixelFormat {
  Word flags, fourCc, bitCount, red, green, blue, alpha;
  bool operator==(const PixelFormat&) const = default;
};

struct FormatRow {
  TexelFormat format;
  std::string_view name;
  int channels;
  std::size_t bytes;
  Word dxgi;
  PixelFormat legacy;
};

constexpr std::array<FormatRow, 7> kFormats = {{
    {TexelFormat::r8, "r8", 1, 1, 61, {kPixelLuminance, 0, 8, 0xff, 0, 0, 0}},
    {TexelFormat::rg8, "rg8", 2, 2, 49, {kPixelLuminance | kPixelAlpha, 0, 16, 0xff, 0, 0, 0xff00}},
    {TexelFormat::rgba8,
     "rgba8",
     4,
     4,
     28,
     {kPixelRgb | kPixelAlpha, 0, 32, 0xff, 0xff00, 0xff0000, 0xff000000}},
    {TexelFormat::r32f, "r32f", 1, 4, 41, {kPixelFourCc, 114, 0, 0, 0, 0, 0}},
    {TexelFormat::rgba32f, "rgba32f", 4, 16, 2, {kPixelFourCc, 116, 0, 0, 0, 0, 0}},
    {TexelFormat::a8, "a8", 1, 1, 65, {kPixelAlphaAlone, 0, 8, 0, 0, 0, 0xff}},
    {TexelFormat::r16, "r16", 1, 2, 56, {kPixelLuminance, 0, 16, 0xffff, 0, 0, 0}},
}};
constexpr PixelFormat kBgra = {kPixelRgb | kPixelAlpha, 0, 32, 0xff0000, 0xff00, 0xff, 0xff000000};
constexpr PixelFormat kBgrx = {kPixelRgb, 0, 32, 0xff0000, 0xff00, 0xff, 0};
constexpr Word kDxgiBgra = 87;

const FormatRow& rowOf(TexelFormat format) { return kFormats[static_cast<std::size_t>(format)]; }

Word littleEndian(std::span<const std::byte> bytes, std::size_t word) {
  Word value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | std::to_integer<Word>(bytes[word * 4 + i]);
  return value;
}

// Reads one file's header, field by field; every refusal names its field.
class HeaderReader {
 public:
  HeaderReader(std::span<const std::byte> bytes, std::string_view name) : bytes_(bytes), name_(name) {
    if (bytes.size() < 4 || word(kMagic) != kDds) fail("magic number", "not a DDS file");
    needs(kLegacyWords);
    if (word(kHeaderSize) != 124) fail("header size", std::to_string(word(kHeaderSize)) + " instead of 124");
    if (word(kPixelSize) != 32)
      fail("pixel format size", std::to_string(word(kPixelSize)) + " instead of 32");
    dx10_ = (word(kPixelFlags) & kPixelFourCc) != 0 && word(kFourCc) == kDx10;
    if (dx10_) needs(kLegacyWords + kDx10Words);
  }

  // All but the texels.
  TextureData shape() {
    TextureData texture;
    texture.format = format();
    const bool volume = isVolume();
    const int limit = volume ? kMaxSide3D : kMaxSide2D;
    texture.width = side(kWidth, "width", limit);
    texture.height = side(kHeight, "height", limit);
    if (volume) texture.depth = side(kDepth, "depth", limit);
    return texture;
  }

  bool swapsRedAndBlue() const { return swaps_; }
  bool opaque() const { return opaque_; }
  std::size_t dataStart() const { return (kLegacyWords + (dx10_ ? kDx10Words : 0)) * 4; }

  // What all mip levels need, in bytes. The count holds without its flag too, which some writers leave out
  // and readers should not rely on (DDS_HEADER, remarks on dwFlags); 0 is one level.
  std::uint64_t dataBytes(const TextureData& shape) const {
    const Word levels = std::max<Word>(word(kMipCount), 1);
    const auto longest = static_cast<Word>(std::max({shape.width, shape.height, shape.depth}));
    const auto most = static_cast<Word>(std::bit_width(longest));  // the last level is one texel
    if (levels > most) {
      fail("mip levels", std::to_string(levels) + " is out of range 1 to " + std::to_string(most));
    }
    std::uint64_t total = 0;
    for (Word level = 0; level < levels; ++level) {
      const auto at = [level](int side) { return static_cast<std::uint64_t>(std::max(side >> level, 1)); };
      total += at(shape.width) * at(shape.height) * at(shape.depth) * texelBytes(shape.format);
    }
    if (total > kMaxBytes) fail("size", std::to_string(total >> 20) + " MiB of texels: more than 256 MiB");
    return total;
  }

  [[noreturn]] void fail(std::string_view field, const std::string& reason) const {
    throw DataError(name_, field, reason);
  }

 private:
  Word word(std::size_t index) const { return littleEndian(bytes_, index); }

  void needs(std::size_t words) const {
    if (bytes_.size() < words * 4) {
      fail("header", "the file ends after " + std::to_string(bytes_.size()) + " of " +
                         std::to_string(words * 4) + " bytes");
    }
  }

  bool isVolume() const {
    if (!dx10_) {
      if ((word(kCaps2) & kCaps2Cube) != 0) fail("caps2", "a cube map");
      // Either says it: Direct3D's own reader goes by the flag, older writers set the capability alone.
      return (word(kCaps2) & kCaps2Volume) != 0 || (word(kFlags) & kFlagDepth) != 0;
    }
    if ((word(kMisc) & kMiscCube) != 0) fail("misc flag", "a cube map");
    if (word(kArraySize) != 1) fail("array size", std::to_string(word(kArraySize)) + " instead of 1");
    if (word(kDimension) != kDimension2D && word(kDimension) != kDimension3D) {
      fail("dimension", std::to_string(word(kDimension)) + " is neither 3 (2D) nor 4 (volume)");
    }
    return word(kDimension) == kDimension3D;
  }

  TexelFormat format() {
    if (dx10_) {
      swaps_ = word(kDxgiFormat) == kDxgiBgra;
      if (swaps_) return TexelFormat::rgba8;
      for (const FormatRow& row : kFormats) {
        if (row.dxgi == word(kDxgiFormat)) return row.format;
      }
      fail("DXGI format",
           std::to_string(word(kDxgiFormat)) + " is not among 2, 28, 41, 49, 56, 61, 65 and 87");
    }
    const PixelFormat stored = storedPixelFormat();
    opaque_ = stored == kBgrx;
    swaps_ = opaque_ || stored == kBgra;
    if (swaps_) return TexelFormat::rgba8;
    for (const FormatRow& row : kFormats) {
      if (row.legacy == stored) return row.format;
    }
    fail("pixel format", "flags " + std::to_string(stored.flags) + ", code " + std::to_string(stored.fourCc) +
                             ", " + std::to_string(stored.bitCount) + " bits: not one that is read");
  }

  // Fields that the flags leave without meaning count as 0.
  PixelFormat storedPixelFormat() const {
    const Word flags =
        word(kPixelFlags) & (kPixelAlpha | kPixelAlphaAlone | kPixelFourCc | kPixelRgb | kPixelLuminance);
    if ((flags & kPixelFourCc) != 0) return {kPixelFourCc, word(kFourCc), 0, 0, 0, 0, 0};
    const bool rgb = (flags & kPixelRgb) != 0, alpha = (flags & (kPixelAlpha | kPixelAlphaAlone)) != 0;
    return {flags,
            0,
            word(kBitCount),
            rgb || (flags & kPixelLuminance) != 0 ? word(kRedMask) : 0,
            rgb ? word(kGreenMask) : 0,
            rgb ? word(kBlueMask) : 0,
            alpha ? word(kAlphaMask) : 0};
  }

  int side(Field field, std::string_view called, int limit) const {
    const Word value = word(field);
    if (value < 1 || value > static_cast<Word>(limit)) {
      fail(called, std::to_string(value) + " is out of range 1 to " + std::to_string(limit));
    }
    return static_cast<int>(value);
  }

  std::span<const std::byte> bytes_;
  std::string_view name_;
  bool dx10_ = false, swaps_ = false, opaque_ = false;
};

}  // namespace

int channelCount(TexelFormat format) { return rowOf(format).channels; }
std::size_t texelBytes(TexelFormat format) { return rowOf(format).bytes; }
std::string_view texelFormatName(TexelFormat format) { return rowOf(format).name; }

TextureData::TextureData(TexelFormat f, int w, int h, int d) : format(f), width(w), height(h), depth(d) {
  assert(w > 0 && h > 0 && d >= 0);
  texels.resize(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) *
                static_cast<std::size_t>(std::max(d, 1)) * texelBytes(f));
}

TextureData decodeDds(std::span<const std::byte> bytes, std::string_view name) {
  HeaderReader header(bytes, name);
  TextureData texture = header.shape();
  const std::uint64_t expected = header.dataBytes(texture), present = bytes.size() - header.dataStart();
  if (present != expected) {
    header.fail("texels",
                std::to_string(present) + " bytes where the header says " + std::to_string(expected));
  }
  texture = TextureData(texture.format, texture.width, texture.height, texture.depth);
  std::memcpy(texture.texels.data(), bytes.data() + header.dataStart(), texture.texels.size());
  if (header.swapsRedAndBlue()) {
    for (std::size_t i = 0; i < texture.texels.size(); i += 4) {
      std::swap(texture.texels[i], texture.texels[i + 2]);
      if (header.opaque()) texture.texels[i + 3] = std::byte{0xff};
    }
  }
  return texture;
}

std::vector<std::byte> encodeDds(const TextureData& texture, DdsHeader header) {
  const FormatRow& row = rowOf(texture.format);
  std::array<Word, kLegacyWords + kDx10Words> words = {};
  words[kMagic] = kDds;
  words[kHeaderSize] = 124;
  words[kFlags] = kFlagCaps | kFlagHeight | kFlagWidth | kFlagPitch | kFlagPixelFormat;
  words[kHeight] = static_cast<Word>(texture.height);
  words[kWidth] = static_cast<Word>(texture.width);
  words[kPitch] = static_cast<Word>(texture.width) * static_cast<Word>(row.bytes);
  words[kPixelSize] = 32;
  words[kCaps] = kCapsTexture;
  if (texture.isVolume()) {
    words[kFlags] |= kFlagDepth;
    words[kDepth] = static_cast<Word>(texture.depth);
    words[kCaps] |= kCapsComplex;
    words[kCaps2] = kCaps2Volume;
  }
  const bool dx10 = header == DdsHeader::dx10;
  const PixelFormat pixel = dx10 ? PixelFormat{kPixelFourCc, kDx10, 0, 0, 0, 0, 0} : row.legacy;
  const Word fields[] = {pixel.flags, pixel.fourCc, pixel.bitCount, pixel.red,
                         pixel.green, pixel.blue,   pixel.alpha};
  std::copy(std::begin(fields), std::end(fields), words.begin() + kPixelFlags);
  words[kDxgiFormat] = row.dxgi;
  words[kDimension] = texture.isVolume() ? kDimension3D : kDimension2D;
  words[kArraySize] = 1;

  std::vector<std::byte> bytes;
  const std::size_t headerWords = kLegacyWords + (dx10 ? kDx10Words : 0);
  bytes.reserve(headerWords * 4 + texture.texels.size());
  for (std::size_t i = 0; i < headerWords; ++i) {
    for (int shift = 0; shift < 32; shift += 8)
      bytes.push_back(static_cast<std::byte>(words[i] >> shift & 0xff));
  }
  bytes.insert(bytes.end(), texture.texels.begin(), texture.texels.end());
  return bytes;
}

TextureData readDds(const std::filesystem::path& path) { return decodeDds(readFile(path), path.string()); }

void writeDds(const std::filesystem::path& path, const TextureData& texture, DdsHeader header) {
  writeFileAtomically(path, encodeDds(texture, header));
}

}  // namespace skydrop::core
