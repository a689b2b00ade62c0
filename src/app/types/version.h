#pragma once

#include <string>

namespace skydrop::app {

// MAJOR.MINOR.PATCH. MINOR rises with every change of what the simulation computes: a replay that another
// version recorded may then end elsewhere (docs/determinism.md).
extern const char* const kVersion;

// As records name the program that made them.
std::string programName();

}  // namespace skydrop::app
