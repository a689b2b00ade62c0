// Soak tests are short by default and long under SKYDROP_SOAK=1.
#pragma once

#include <cstdlib>
#include <string_view>

namespace skydrop::test {

inline bool soaking() {
  const char* value = std::getenv("SKYDROP_SOAK");
  return value != nullptr && std::string_view(value) == "1";
}

}  // namespace skydrop::test
