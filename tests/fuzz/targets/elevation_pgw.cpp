// Elevation: the place of a picture of heights, in the file beside it.
#include "fuzz/elevation_input.h"
#include "skydrop/core/assets.h"
#include "skydrop/core/file.h"

using namespace skydrop;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string png =
      core::readTextFile(core::dataFolder().string() + "/tests/corpus/elevation/goodTerrarium.png");
  fuzz::inputFile("a.pgw", data, size);
  fuzz::readElevation("a.png", reinterpret_cast<const std::uint8_t*>(png.data()), png.size());
  return 0;
}
