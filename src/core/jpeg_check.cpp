#include "core/jpeg_check.h"

#include <optional>
#include <string>

#include "skydrop/core/error.h"

namespace skydrop::core {
namespace {

constexpr int kStart = 0xd8, kEnd = 0xd9, kScan = 0xda, kFirstRestart = 0xd0, kLastRestart = 0xd7,
              kTemporary = 0x01, kFirstFrame = 0xc0, kLastFrame = 0xcf, kHuffmanTables = 0xc4,
              kReserved = 0xc8, kArithmeticTables = 0xcc, kProgressiveFrame = 0xc2;

bool isFrame(int marker) {
  return marker >= kFirstFrame && marker <= kLastFrame && marker != kHuffmanTables && marker != kReserved &&
         marker != kArithmeticTables;
}

class Walk {
 public:
  Walk(std::span<const std::byte> bytes, std::string_view name) : bytes_(bytes), name_(name) {}

  JpegSize run() {
    if (byteAt(0) != 0xff || byteAt(1) != kStart) fail("is no JPEG");
    at_ = 2;
    for (;;) {
      const int marker = nextMarker();
      if (marker == kEnd) break;
      if (marker == kTemporary || (marker >= kFirstRestart && marker <= kLastRestart)) continue;
      const std::size_t length = wordAt(at_);
      if (length < 2) fail("a segment of " + std::to_string(length) + " bytes");
      if (length > bytes_.size() - at_) fail("is cut off");
      if (isFrame(marker)) readFrame(marker, length);
      if (marker == kHuffmanTables) checkHuffmanTables(at_ + 2, at_ + length);
      if (marker == kScan && !size_) fail("a scan before the frame");
      at_ += length;
      if (marker == kScan) skipScan();
    }
    if (!size_ || !hasScan_) throw DataError(name_, "", "has no picture");
    return *size_;
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw DataError(name_, "byte " + std::to_string(at_), reason);
  }
  int byteAt(std::size_t at) const {
    if (at >= bytes_.size()) fail("is cut off");
    return std::to_integer<int>(bytes_[at]);
  }
  std::size_t wordAt(std::size_t at) const {
    return static_cast<std::size_t>(byteAt(at)) << 8 | static_cast<std::size_t>(byteAt(at + 1));
  }
  int nextMarker() {
    if (byteAt(at_) != 0xff) fail("no segment begins here");
    while (byteAt(at_) == 0xff) ++at_;
    return byteAt(at_++);
  }
  void readFrame(int marker, std::size_t length) {
    if (size_) fail("a second frame");
    if (marker > kProgressiveFrame) fail("a coding that is not read: lossless, hierarchical or arithmetic");
    if (length < 8) fail("a frame header of " + std::to_string(length) + " bytes");
    if (byteAt(at_ + 2) != 8) fail("has " + std::to_string(byteAt(at_ + 2)) + " bits, not 8");
    JpegSize size;
    size.height = static_cast<int>(wordAt(at_ + 3));
    size.width = static_cast<int>(wordAt(at_ + 5));
    size.components = byteAt(at_ + 7);
    size.isProgressive = marker == kProgressiveFrame;
    if (size.components != 1 && size.components != 3)
      fail("has " + std::to_string(size.components) + " components, not 1 or 3");
    size_ = size;
  }
  // A decoder has room for 256 codes, and trusts their lengths (ISO/IEC 10918-1, B.2.4.2 and C.2).
  void checkHuffmanTables(std::size_t from, std::size_t end) const {
    while (from < end) {
      std::size_t codes = 0, used = 0;  // `used` of the 2^length codes that there are
      if (end - from < 17) fail("a Huffman table that is cut off");
      for (std::size_t length = 1; length <= 16; ++length) {
        const auto count = static_cast<std::size_t>(byteAt(from + length));
        codes += count;
        used = 2 * used + count;
        if (used > std::size_t{1} << length) fail("more Huffman codes than there are");
      }
      if (codes > 256) fail("a Huffman table of " + std::to_string(codes) + " codes");
      if (codes > end - from - 17) fail("a Huffman table that is cut off");
      from += 17 + codes;
    }
  }

  // To the next marker that ends the coded data: FF 00 and restarts belong to them.
  void skipScan() {
    hasScan_ = true;
    for (;; ++at_) {
      if (byteAt(at_) != 0xff) continue;
      const int next = byteAt(at_ + 1);
      if (next != 0 && next != 0xff && (next < kFirstRestart || next > kLastRestart)) return;
    }
  }

  std::span<const std::byte> bytes_;
  std::string_view name_;
  std::size_t at_ = 0;
  std::optional<JpegSize> size_;
  bool hasScan_ = false;
};

}  // namespace

JpegSize checkJpeg(std::span<const std::byte> bytes, std::string_view name) {
  return Walk(bytes, name).run();
}

}  // namespace skydrop::core
