// Textures and volumes in memory, and DDS files of them. Any thread.
// Format: Microsoft, "DDS file layout for textures" and "DDS_HEADER_DXT10" (legacy and DX10 headers).
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace skydrop::core {

// Unsigned normalised bytes, 16-bit words (r16) or 32-bit floats; one, two or four channels in the order red,
// green, blue, alpha. r8 and r16 are LUMINANCE in a legacy file; a8 is alpha alone. Words and floats are
// little-endian.
enum class TexelFormat { r8, rg8, rgba8, r32f, rgba32f, a8, r16 };

int channelCount(TexelFormat format);
std::size_t texelBytes(TexelFormat format);
std::string_view texelFormatName(TexelFormat format);

// Texels x fastest, then y, then z, without padding; row 0 is the first row of the file (v = 0 for OpenGL).
// `depth` is 0 for a 2D texture and at least 1 for a volume.
struct TextureData {
  TexelFormat format = TexelFormat::rgba8;
  int width = 0;
  int height = 0;
  int depth = 0;
  std::vector<std::byte> texels;

  TextureData() = default;
  TextureData(TexelFormat format, int width, int height, int depth);  // all zero

  bool isVolume() const { return depth > 0; }
  bool operator==(const TextureData&) const = default;
};

enum class DdsHeader { legacy, dx10 };

// The first mip level of a 2D texture or a volume. Reads both headers, legacy BGRA and BGRX as RGBA. A legacy
// file is a volume by its depth flag or its capability; the mip count holds with and without its flag. Throws
// DataError with the field at fault (`name: field: reason`) for another magic number, a size outside 1 to
// 16384 (volumes 1 to 2048) or beyond 256 MiB, more mip levels than such a size has, a format other than
// TexelFormat's, cube maps, arrays, and a file that is shorter or longer than its header says. Never reads or
// allocates beyond what the file holds.
TextureData decodeDds(std::span<const std::byte> bytes, std::string_view name);
std::vector<std::byte> encodeDds(const TextureData& texture, DdsHeader header);

TextureData readDds(const std::filesystem::path& path);
void writeDds(const std::filesystem::path& path, const TextureData& texture, DdsHeader header);  // atomically

}  // namespace skydrop::core
