// The failure policy as types (docs/failures.md). Programmer errors are assertions, not exceptions. What
// every one of them says is one printable line of bounded length (message.h), whatever it quotes.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace skydrop::core {

// Bad data: a file that cannot be opened, read or written, or whose content is wrong. Names the file, the
// place inside it (left out when empty) and the reason, in one line. At start it ends the program with exit
// code 1; while running the last good state is kept and the line is shown in the menu.
class DataError : public std::runtime_error {
 public:
  DataError(std::string_view file, std::string_view place, std::string_view reason);
};

// What can be judged from the command line alone: flag, size, --set path or value. Exit code 2.
class UsageError : public std::runtime_error {
 public:
  explicit UsageError(std::string_view message);
};

// A value from outside that a function refuses at its door (not finite, out of range). One line.
class RangeError : public std::runtime_error {
 public:
  explicit RangeError(std::string_view message);
};

// No OpenGL 4.5 core context, or no display for the window. Exit code 3.
class GraphicsUnavailable : public std::runtime_error {
 public:
  explicit GraphicsUnavailable(std::string_view message);
};

}  // namespace skydrop::core
