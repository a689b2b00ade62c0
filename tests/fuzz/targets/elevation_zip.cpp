// Elevation: SRTM tiles in a zip archive.
#include "fuzz/elevation_input.h"

using namespace skydrop;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::readElevation("N46E007.hgt.zip", data, size);
  return 0;
}
