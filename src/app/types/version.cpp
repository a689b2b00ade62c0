#include "app/types/version.h"

namespace skydrop::app {

const char* const kVersion = SKYDROP_VERSION;

std::string programName() { return std::string("skydrop ") + kVersion; }

}  // namespace skydrop::app
