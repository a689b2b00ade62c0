// The line with which something is refused.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace skydrop::test {

// What the `Error` says that the action throws; empty when it throws nothing. Other exceptions pass.
template <class Error>
std::string refusalOf(const auto& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

// Whether what was said is one printable line of bounded length that names the file.
inline bool isOneLineAbout(std::string_view line, std::string_view file) {
  const auto isPrintable = [](unsigned char c) { return c >= 0x20 && c != 0x7f; };
  return std::all_of(line.begin(), line.end(), isPrintable) && line.size() <= 1000 &&
         line.find(file) != std::string_view::npos;
}

}  // namespace skydrop::test
