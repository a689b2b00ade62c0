// The segments of a JPEG file, before a decoder sees them.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace skydrop::core {

struct JpegSize {
  int width = 0, height = 0, components = 0;
  bool isProgressive = false;
};

// Walks the segments from the first to the end mark. Throws DataError that names the place, unless there is
// one frame of 8 bits, baseline, extended or progressive by Huffman codes, with one or three components, and
// all segments and the end mark are there (ITU T.81, annex B).
JpegSize checkJpeg(std::span<const std::byte> bytes, std::string_view name);

}  // namespace skydrop::core
