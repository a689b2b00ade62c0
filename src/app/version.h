#pragma once

#include <string>

namespace skydrop::app {

inline constexpr const char* kVersion = SKYDROP_VERSION;

// As records name the program that made them.
inline std::string programName() { return std::string("skydrop ") + kVersion; }

}  // namespace skydrop::app
