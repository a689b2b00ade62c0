// Settings as words of a command line: what the menu's copy button hands over, and what a shell gives back to
// the program bit for bit.
#pragma once

#include <string>
#include <string_view>

#include "skydrop/core/settings_table.h"

namespace skydrop::core {

// `word` as a POSIX shell reads it back, whatever it holds but a zero byte: as it is where every character is
// a plain one, else in single quotes.
std::string shellQuoted(std::string_view word);

// "--set path=value" for each field that differs from `base`, a table of the same description: in the order
// of the table, quoted, separated by spaces, numbers with the fewest digits that read back to the same bits.
// Empty where nothing differs.
std::string setFlags(const SettingsTable& table, const SettingsTable& base);

}  // namespace skydrop::core
