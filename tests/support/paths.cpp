#include "support/paths.h"

#include <cstdlib>

namespace skydrop::test {
namespace {

// Where a bundle was unpacked (tests/device/bundle.sh); empty: nowhere, the tests run where they were built.
std::string bundle() {
  const char* folder = std::getenv("SKYDROP_TEST_BUNDLE");
  return folder ? folder : "";
}

std::string inBundleOr(const char* inBundle, const char* otherwise) {
  return bundle().empty() ? otherwise : bundle() + inBundle;
}

}  // namespace

std::string sourceDir() { return inBundleOr("", SKYDROP_SOURCE_DIR); }
std::string binaryDir() { return inBundleOr("", SKYDROP_BINARY_DIR); }
std::string programFile() { return inBundleOr("/skydrop", SKYDROP_PROGRAM); }

}  // namespace skydrop::test
