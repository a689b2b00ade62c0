// Settings as words of a command line: what the menu's copy button hands over, and what a shell gives back to
// the program bit for bit.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "skydrop/core/settings_table.h"

namespace skydrop::core {

// `word` as a POSIX shell reads it back, whatever it holds but a zero byte: as it is where every character is
// a plain one, else in single quotes.
std::string shellQuoted(std::string_view word);

// "--set path=value" for each field that differs from one of `bases`, tables of the same description: in the
// order of the table, quoted, separated by spaces, numbers with the fewest digits that read back to the same
// bits. Empty where nothing differs. Whichever of the bases a run starts from, the flags make it equal to
// `table`.
std::string setFlags(const SettingsTable& table, std::span<const SettingsTable* const> bases);

}  // namespace skydrop::core
