#include "support/paths.h"

namespace skydrop::test {

std::string sourceDir() { return SKYDROP_SOURCE_DIR; }
std::string binaryDir() { return SKYDROP_BINARY_DIR; }
std::string programFile() { return SKYDROP_PROGRAM; }

}  // namespace skydrop::test
