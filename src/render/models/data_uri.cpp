#include "render/models/data_uri.h"

#include <charconv>
#include <cstdint>

#include "skydrop/core/error.h"

namespace skydrop::render {

using core::DataError;

bool isDataUri(std::string_view uri) { return uri.starts_with("data:"); }

std::vector<std::byte> decodeDataUri(std::string_view uri, const std::string& file,
                                     const std::string& place) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos || !uri.substr(0, comma).ends_with(";base64")) {
    throw DataError(file, place, "a data URI that is not base64");
  }
  std::string_view text = uri.substr(comma + 1);
  if (text.size() % 4 != 0) throw DataError(file, place, "base64 whose length is not a multiple of 4");
  for (int i = 0; i < 2 && text.ends_with('='); ++i) text.remove_suffix(1);
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::byte> bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const std::size_t digit = kDigits.find(c);
    if (digit == std::string_view::npos) throw DataError(file, place, "a character that is not base64");
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes.push_back(static_cast<std::byte>(bits >> count));
    }
  }
  return bytes;
}

std::string decodePercent(std::string_view uri, const std::string& file, const std::string& place) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] != '%') {
      text += uri[i];
      continue;
    }
    unsigned char byte = 0;
    const std::string_view digits = uri.substr(i + 1, 2);
    const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), byte, 16);
    if (digits.size() != 2 || parsed.ptr != digits.data() + 2) {
      throw DataError(file, place, "a percent sign that two hexadecimal digits do not follow");
    }
    text += static_cast<char>(byte);
    i += 2;
  }
  return text;
}

}  // namespace skydrop::render
