// Elevation: ESRI ASCII grid.
#include "fuzz/elevation_input.h"

using namespace skydrop;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::readElevation("a.asc", data, size);
  return 0;
}
