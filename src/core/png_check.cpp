#include "core/png_check.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <initializer_list>
#include <string>

#include "skydrop/core/error.h"

namespace skydrop::core {
namespace {

constexpr std::array<unsigned char, 8> kSignature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
constexpr std::size_t kHeaderBytes = 13;

// CRC-32 of ISO 3309, as the specification's annex D has it.
constexpr std::array<std::uint32_t, 256> crcTable() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t i = 0; i < table.size(); ++i) {
    std::uint32_t c = i;
    for (int bit = 0; bit < 8; ++bit) c = (c & 1) != 0 ? 0xedb88320u ^ (c >> 1) : c >> 1;
    table[i] = c;
  }
  return table;
}

std::uint32_t crc32(std::span<const std::byte> bytes) {
  static constexpr std::array<std::uint32_t, 256> kTable = crcTable();
  std::uint32_t crc = 0xffffffffu;
  for (const std::byte b : bytes) crc = kTable[(crc ^ std::to_integer<std::uint32_t>(b)) & 0xff] ^ (crc >> 8);
  return ~crc;
}

std::uint32_t bigEndian(std::span<const std::byte> bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | std::to_integer<std::uint32_t>(bytes[i]);
  return value;
}

int channels(int colourType) {
  switch (colourType) {
    case 2:
      return 3;
    case 4:
      return 2;
    case 6:
      return 4;
    default:
      return 1;
  }
}

std::uint64_t bytesOf(std::uint64_t width, std::uint64_t height, std::uint64_t bitsPerPixel) {
  return width == 0 || height == 0 ? 0 : (1 + (width * bitsPerPixel + 7) / 8) * height;
}

// Of the picture, or of the seven of an interlaced one.
std::uint64_t rowBytes(std::uint64_t width, std::uint64_t height, std::uint64_t bitsPerPixel,
                       bool interlaced) {
  if (!interlaced) return bytesOf(width, height, bitsPerPixel);
  struct Pass {
    std::uint64_t x, y, stepX, stepY;
  };
  constexpr std::array<Pass, 7> kAdam7 = {
      {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4}, {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}}};
  std::uint64_t bytes = 0;
  for (const Pass& pass : kAdam7) {
    const auto count = [](std::uint64_t size, std::uint64_t first, std::uint64_t step) {
      return size > first ? (size - first + step - 1) / step : 0;
    };
    bytes += bytesOf(count(width, pass.x, pass.stepX), count(height, pass.y, pass.stepY), bitsPerPixel);
  }
  return bytes;
}

class ChunkReader {
 public:
  ChunkReader(std::span<const std::byte> bytes, std::string_view name)
      : file_(bytes), rest_(bytes), name_(name) {
    if (bytes.size() < kSignature.size() ||
        std::memcmp(bytes.data(), kSignature.data(), kSignature.size()) != 0)
      fail("signature", "not a PNG file");
    rest_ = bytes.subspan(kSignature.size());
  }

  PngContent read() {
    PngContent content;
    bool hasHeader = false;
    while (true) {
      const std::size_t before = file_.size() - rest_.size();
      const Chunk chunk = next();
      if (!hasHeader && chunk.type != "IHDR") fail("chunk IHDR", "is not the first");
      if (hasHeader && chunk.type == "IHDR") fail("chunk IHDR", "is there twice");
      if (!hasHeader) readHeader(chunk.data, content);
      hasHeader = true;
      if (chunk.type == "IDAT") {
        if (content.head.empty()) content.head = file_.first(before);
        content.compressed.insert(content.compressed.end(), chunk.data.begin(), chunk.data.end());
      }
      if (chunk.type == "tEXt" || chunk.type == "iTXt") readText(chunk, content);
      if (chunk.type == "IEND") break;
    }
    if (content.compressed.empty()) fail("chunk IDAT", "is missing");
    return content;
  }

 private:
  struct Chunk {
    std::string_view type;
    std::span<const std::byte> data;
  };

  [[noreturn]] void fail(std::string_view place, std::string_view reason) const {
    throw DataError(name_, place, reason);
  }

  Chunk next() {
    if (rest_.size() < 8) fail("chunk IEND", "is missing: the file is cut off");
    const std::size_t length = bigEndian(rest_);
    const std::string_view type(reinterpret_cast<const char*>(rest_.data()) + 4, 4);
    const std::string place = "chunk " + std::string(type);
    if (rest_.size() - 8 < 4 || length > rest_.size() - 12) fail(place, "is cut off, as the file is");
    const Chunk chunk{type, rest_.subspan(8, length)};
    if (crc32(rest_.subspan(4, 4 + length)) != bigEndian(rest_.subspan(8 + length)))
      fail(place, "its checksum is wrong");
    rest_ = rest_.subspan(12 + length);
    return chunk;
  }

  void readHeader(std::span<const std::byte> data, PngContent& content) const {
    if (data.size() != kHeaderBytes) fail("chunk IHDR", "is of the wrong length");
    content.width = bigEndian(data);
    content.height = bigEndian(data.subspan(4));
    const auto field = [&](std::size_t i) { return std::to_integer<int>(data[i]); };
    const auto bits = static_cast<std::uint64_t>(field(8) * channels(field(9)));
    content.rowBytes = rowBytes(content.width, content.height, bits, field(12) != 0);
  }

  // A keyword, and behind a null the text; in iTXt there are two bytes, a language and a translated keyword
  // between. Texts are beside the picture: one that is malformed is left out.
  static void readText(const Chunk& chunk, PngContent& content) {
    std::string_view text(reinterpret_cast<const char*>(chunk.data.data()), chunk.data.size());
    const auto upToNull = [&text] {
      const std::string_view part = text.substr(0, text.find('\0'));
      text.remove_prefix(std::min(part.size() + 1, text.size()));
      return part;
    };
    if (text.find('\0') == std::string_view::npos) return;
    const std::string_view keyword = upToNull();
    if (chunk.type == "iTXt") {
      if (text.size() < 2 || text[0] != 0) return;
      text.remove_prefix(2);
      upToNull();
      upToNull();
    }
    content.texts.push_back({std::string(keyword), std::string(text)});
  }

  std::span<const std::byte> file_, rest_;
  std::string_view name_;
};

}  // namespace

PngContent checkPng(std::span<const std::byte> bytes, std::string_view name) {
  return ChunkReader(bytes, name).read();
}

bool matchesChecksum(std::span<const std::byte> rows, std::span<const std::byte> compressed) {
  constexpr std::uint32_t kBase = 65521;
  constexpr std::size_t kBlock = 5552;  // the most sums that fit 32 bits
  std::uint32_t a = 1, b = 0;
  for (std::size_t at = 0; at < rows.size(); at += kBlock) {
    for (const std::byte value : rows.subspan(at, std::min(kBlock, rows.size() - at))) {
      a += std::to_integer<std::uint32_t>(value);
      b += a;
    }
    a %= kBase;
    b %= kBase;
  }
  return compressed.size() >= 4 && bigEndian(compressed.last(4)) == (b << 16 | a);
}

std::vector<std::byte> withStoredRows(const PngContent& content, std::span<const std::byte> rows) {
  constexpr std::size_t kBlock = 65535;  // of a stored block (RFC 1951, 3.2.4)
  constexpr std::size_t kNoChecksum = 4;
  const std::size_t blocks = std::max<std::size_t>((rows.size() + kBlock - 1) / kBlock, 1);
  const std::size_t length = 2 + 5 * blocks + rows.size() + kNoChecksum;
  std::vector<std::byte> file(content.head.begin(), content.head.end());
  file.reserve(file.size() + length + 24);
  const auto put = [&file](std::initializer_list<std::size_t> values) {
    for (const std::size_t value : values) file.push_back(static_cast<std::byte>(value & 0xff));
  };
  const auto putName = [&](const char* name) {
    for (int i = 0; i < 4; ++i) put({static_cast<unsigned char>(name[i])});
  };
  put({length >> 24, length >> 16, length >> 8, length});
  putName("IDAT");
  put({0x78, 0x01});
  for (std::size_t block = 0; block < blocks; ++block) {
    const auto part = rows.subspan(block * kBlock, std::min(kBlock, rows.size() - block * kBlock));
    const std::size_t size = part.size(), other = ~size;
    put({block + 1 == blocks ? 1u : 0u, size, size >> 8, other, other >> 8});
    file.insert(file.end(), part.begin(), part.end());
  }
  file.resize(file.size() + 2 * kNoChecksum + 4);  // of stream and chunk; then the length of the end chunk
  putName("IEND");
  put({0, 0, 0, 0});
  return file;
}

std::vector<std::byte> withTexts(std::span<const std::byte> png, std::span<const PictureText> texts) {
  constexpr std::size_t kBegin = kSignature.size() + 12 + kHeaderBytes;  // behind the header's chunk
  std::vector<std::byte> file(png.begin(), png.begin() + kBegin);
  const auto putNumber = [&file](std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8)
      file.push_back(static_cast<std::byte>(value >> shift & 0xff));
  };
  for (const PictureText& text : texts) {
    // Behind the keyword: not compressed, no language, no translated keyword.
    const std::string content = "iTXt" + text.keyword + std::string(5, '\0') + text.text;
    const auto bytes = std::as_bytes(std::span(content));
    putNumber(static_cast<std::uint32_t>(bytes.size() - 4));
    file.insert(file.end(), bytes.begin(), bytes.end());
    putNumber(crc32(bytes));
  }
  file.insert(file.end(), png.begin() + kBegin, png.end());
  return file;
}

}  // namespace skydrop::core
