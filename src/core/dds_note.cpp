#include "skydrop/core/dds_note.h"

#include <cassert>

namespace skydrop::core {
namespace {

constexpr std::size_t kFirstByte = 8 * 4;

}  // namespace

void putNote(std::span<std::byte> dds, const DdsNote& note) {
  assert(dds.size() >= kFirstByte + sizeof note);
  for (std::size_t i = 0; i < note.size() * 4; ++i)
    dds[kFirstByte + i] = static_cast<std::byte>(note[i / 4] >> (8 * (i % 4)) & 0xff);
}

DdsNote noteOf(std::span<const std::byte> dds) {
  DdsNote note = {};
  if (dds.size() < kFirstByte + sizeof note) return note;
  for (std::size_t i = 0; i < note.size() * 4; ++i)
    note[i / 4] |= std::to_integer<std::uint32_t>(dds[kFirstByte + i]) << (8 * (i % 4));
  return note;
}

}  // namespace skydrop::core
