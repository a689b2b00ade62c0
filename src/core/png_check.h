// What stb_image does not look at: a PNG's structure and its checksums. Private to core; any thread.
// Format: W3C, "Portable Network Graphics (PNG) Specification", third edition, 5 and 13.2; RFC 1950 (zlib).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "skydrop/core/image.h"

namespace skydrop::core {

struct PngContent {
  std::uint32_t width = 0, height = 0;
  std::uint64_t rowBytes = 0;         // of all rows, filter bytes included, once inflated
  std::span<const std::byte> head;    // of the file: all before its first IDAT chunk
  std::vector<std::byte> compressed;  // the zlib stream of all IDAT chunks
  std::vector<PictureText> texts;     // of tEXt chunks and of iTXt chunks that are not compressed
};

// Signature, order, lengths and checksums of the chunks up to IEND; what follows is not looked at. Throws
// DataError that names the chunk.
PngContent checkPng(std::span<const std::byte> bytes, std::string_view name);

// Whether the inflated rows are what the zlib stream's checksum says.
bool matchesChecksum(std::span<const std::byte> rows, std::span<const std::byte> compressed);

// The same picture with its rows stored as they are, for a reader that compares no checksums: there are none.
std::vector<std::byte> withStoredRows(const PngContent& content, std::span<const std::byte> rows);

// The file with `texts` as iTXt chunks behind its header. `png` is one that stb_image wrote.
std::vector<std::byte> withTexts(std::span<const std::byte> png, std::span<const PictureText> texts);

}  // namespace skydrop::core
