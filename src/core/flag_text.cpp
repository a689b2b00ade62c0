#include "skydrop/core/flag_text.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace skydrop::core {
namespace {

// Letters, digits and signs that no shell reads as anything but themselves.
bool isPlain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("%+,-./:=@_").find(c) != std::string_view::npos;
}

}  // namespace

std::string shellQuoted(std::string_view word) {
  if (!word.empty() && std::ranges::all_of(word, isPlain)) return std::string(word);
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string setFlags(const SettingsTable& table, std::span<const SettingsTable* const> bases) {
  std::string flags;
  for (std::size_t i = 0; i < table.fields().size(); ++i) {
    const Field& field = table.fields()[i];
    const auto bits = [](const Field& f) { return std::bit_cast<std::uint64_t>(f.get()); };
    const auto isSame = [&](const SettingsTable* base) { return bits(field) == bits(base->fields()[i]); };
    if (std::ranges::all_of(bases, isSame)) continue;
    flags += (flags.empty() ? "--set " : " --set ") + shellQuoted(field.path + "=" + fieldText(field));
  }
  return flags;
}

}  // namespace skydrop::core
