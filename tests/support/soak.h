// How much a test may take its time: soak tests are short by default and long under SKYDROP_SOAK=1; what
// tries every combination or every step of every row tries a third of them unless SKYDROP_ALL=1 (test.sh
// --all) or soaking.
#pragma once

#include <cstdlib>
#include <string_view>

namespace skydrop::test {

inline bool isOne(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && std::string_view(value) == "1";
}

inline bool soaking() { return isOne("SKYDROP_SOAK"); }
inline bool triesAll() { return isOne("SKYDROP_ALL") || soaking(); }

}  // namespace skydrop::test
