// Elevation: a coordinate system beside a grid, in words of PROJ or WKT.
#include "fuzz/elevation_input.h"

using namespace skydrop;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string grid =
      "ncols 2\nnrows 2\nxllcorner 600000\nyllcorner 200000\ncellsize 25\n500 501\n502 503\n";
  fuzz::inputFile("a.prj", data, size);
  fuzz::readElevation("a.asc", reinterpret_cast<const std::uint8_t*>(grid.data()), grid.size());
  return 0;
}
