// Elevation: lines of x y z.
#include "fuzz/elevation_input.h"

using namespace skydrop;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::readElevation("a.xyz", data, size);
  return 0;
}
