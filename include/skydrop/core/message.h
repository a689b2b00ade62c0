// Messages for people: one printable line of bounded length, whatever the text that they quote. What a file,
// a name or the command line says reaches the terminal, the menu and the logs only through here. Any thread.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace skydrop::core {

inline constexpr std::size_t kLongestMessage = 1000;  // bytes: a dozen lines of a terminal

// `text` as one line of UTF-8 that shows what it holds: control characters (C0, DEL, C1), line separators,
// invisible and direction-changing characters and bytes that are not UTF-8 as escapes (\n, \x1b, \u202e);
// all else, backslashes included, as it is. Beyond `mostBytes` the middle becomes "...": both ends are kept.
// A text that is one already comes back unchanged.
std::string printable(std::string_view text, std::size_t mostBytes = kLongestMessage);

// "file: place: reason", each part printable and of bounded length. A file without a name is called
// "(no name)"; an empty place is left out; line ends at the end of the reason are dropped.
std::string messageLine(std::string_view file, std::string_view place, std::string_view reason);

}  // namespace skydrop::core
