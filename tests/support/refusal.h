// The line with which something is refused.
#pragma once

#include <string>

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

}  // namespace skydrop::test
