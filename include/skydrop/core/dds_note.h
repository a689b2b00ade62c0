// Eleven words that a DDS header leaves to whoever writes it (dwReserved1): readers skip them. A program's
// own note of how a texture was made fits in. Any thread. Format: Microsoft, "DDS_HEADER structure".
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace skydrop::core {

using DdsNote = std::array<std::uint32_t, 11>;

// Into what encodeDds() made.
void putNote(std::span<std::byte> dds, const DdsNote& note);

// Of a file of any content; zeros where it is too short to have one.
DdsNote noteOf(std::span<const std::byte> dds);

}  // namespace skydrop::core
