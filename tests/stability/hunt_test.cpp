// The hunt through shaders/shared in C++: every function that support/hunt_functions.inl lists. tests/gl has
// the same as GLSL. SKYDROP_HUNT=1000000 tries so many inputs of each (docs/hunt.md).
#include "support/hunt.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "support/instrumented.h"

namespace skydrop::test {
namespace {

constexpr std::uint64_t kSeed = 20;

TEST(Hunt, sharedFunctionsKeepTheirContractInFloat) {
  // Results finite, in range, and those of double for the same inputs or inputs four units in the last place
  // away.
  const auto count = huntedInputs(static_cast<std::uint64_t>(repetitions(4000)));
  const char* only = std::getenv("SKYDROP_HUNT_ONLY");
  std::uint64_t tried = 0;
  for (const HuntedFunction& function : huntedFunctions()) {
    if (only && std::string(only) != function.name) continue;
    const HuntFinding finding = hunt(function, kSeed, 0, count);
    tried += count;
    EXPECT_EQ(finding.faults, 0u) << finding.text;
  }
  std::printf("%zu functions, %llu inputs\n", huntedFunctions().size(),
              static_cast<unsigned long long>(tried));
}

}  // namespace
}  // namespace skydrop::test
