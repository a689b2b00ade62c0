#include "skydrop/core/message.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <vector>

namespace skydrop::core {
namespace {

constexpr std::string_view kOmitted = "...";
constexpr std::size_t kLongestFile = 300, kLongestPlace = 200, kLongestReason = 450;

struct CodePoint {
  std::uint32_t value = 0;
  std::size_t bytes = 0;  // 0: not UTF-8
};

bool isContinuation(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

// The code point at the front of a text that is not empty (RFC 3629: shortest form, no surrogates).
CodePoint front(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  if (first < 0x80) return {first, 1};
  const std::size_t bytes = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || text.size() < bytes) return {};
  std::uint32_t value = first & (0xffu >> (bytes + 1));
  for (std::size_t i = 1; i < bytes; ++i) {
    if (!isContinuation(text[i])) return {};
    value = value << 6 | (static_cast<unsigned char>(text[i]) & 0x3f);
  }
  constexpr std::array<std::uint32_t, 5> kLeast = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = value >= 0xd800 && value <= 0xdfff;
  if (value < kLeast[bytes] || value > 0x10ffff || surrogate) return {};
  return {value, bytes};
}

// Characters that end a line, command a terminal, are not seen, or turn the direction of what follows.
bool isHidden(std::uint32_t c) {
  constexpr std::array<std::array<std::uint32_t, 2>, 11> kHidden = {{{0x00, 0x1f},
                                                                     {0x7f, 0x9f},
                                                                     {0xad, 0xad},
                                                                     {0x61c, 0x61c},
                                                                     {0x180e, 0x180e},
                                                                     {0x200b, 0x200f},
                                                                     {0x2028, 0x202e},
                                                                     {0x2060, 0x206f},
                                                                     {0xfeff, 0xfeff},
                                                                     {0xfff9, 0xfffb},
                                                                     {0xe0000, 0xe0fff}}};
  return std::ranges::any_of(kHidden, [c](const auto& range) { return c >= range[0] && c <= range[1]; });
}

std::string escaped(std::uint32_t c) {
  if (c == '\n') return "\\n";
  if (c == '\r') return "\\r";
  if (c == '\t') return "\\t";
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), c < 0x80 ? "\\x%02x" : c < 0x10000 ? "\\u%04x" : "\\U%08x", c);
  return text.data();
}

// What is shown of a text, and where each character of it begins, so that a cut falls between two.
struct Shown {
  std::string text;
  std::vector<std::size_t> starts;
};

Shown show(std::string_view text) {
  Shown shown;
  while (!text.empty()) {
    shown.starts.push_back(shown.text.size());
    const CodePoint c = front(text);
    if (c.bytes == 0) {
      std::array<char, 8> byte{};
      std::snprintf(byte.data(), byte.size(), "\\x%02x",
                    static_cast<unsigned>(static_cast<unsigned char>(text[0])));
      shown.text += byte.data();
    } else if (isHidden(c.value)) {
      shown.text += escaped(c.value);
    } else {
      shown.text += text.substr(0, c.bytes);
    }
    text.remove_prefix(std::max<std::size_t>(c.bytes, 1));
  }
  return shown;
}

// The largest start that is at most `most`.
std::size_t cutBefore(const Shown& shown, std::size_t most) {
  if (shown.text.size() <= most) return shown.text.size();
  return *std::prev(std::ranges::upper_bound(shown.starts, most));
}

// The smallest start from which at most `most` bytes follow.
std::size_t cutAfter(const Shown& shown, std::size_t most) {
  if (shown.text.size() <= most) return 0;
  const auto start = std::ranges::lower_bound(shown.starts, shown.text.size() - most);
  return start == shown.starts.end() ? shown.text.size() : *start;
}

}  // namespace

std::string printable(std::string_view text, std::size_t mostBytes) {
  // No more than this of either end can be shown: the rest is not looked at.
  std::string_view head = text, tail;
  if (text.size() > 2 * mostBytes) {
    head = text.substr(0, mostBytes);
    tail = text.substr(text.size() - mostBytes);
    while (!tail.empty() && isContinuation(tail[0])) tail.remove_prefix(1);
  }
  const Shown first = show(head);
  if (tail.empty() && first.text.size() <= mostBytes) return first.text;
  const Shown last = tail.empty() ? first : show(tail);
  const std::size_t room = mostBytes - std::min(mostBytes, kOmitted.size());
  const std::string end = last.text.substr(cutAfter(last, room / 2));
  return first.text.substr(0, cutBefore(first, room - room / 2)) + std::string(kOmitted) + end;
}

std::string messageLine(std::string_view file, std::string_view place, std::string_view reason) {
  while (!reason.empty() && (reason.back() == '\n' || reason.back() == '\r')) reason.remove_suffix(1);
  std::string line = file.empty() ? "(no name)" : printable(file, kLongestFile);
  if (!place.empty()) line += ": " + printable(place, kLongestPlace);
  return line + ": " + printable(reason, kLongestReason);
}

}  // namespace skydrop::core
