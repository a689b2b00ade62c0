// Elevation: heights coded as colours.
#include "fuzz/elevation_input.h"

using namespace skydrop;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string place = "10\n0\n0\n-10\n2600005\n1200075\n";
  static const auto world =
      fuzz::inputFile("a.pgw", reinterpret_cast<const std::uint8_t*>(place.data()), place.size());
  const std::vector<std::byte> fixed = fuzz::withPngChecksums(fuzz::bytesOf(data, size));
  fuzz::readElevation("a.png", data, size);
  fuzz::readElevation("a.png", reinterpret_cast<const std::uint8_t*>(fixed.data()), fixed.size());
  return 0;
}
