// Places with names.
#include "skydrop/elevation/places.h"

#include "fuzz/fuzz_input.h"

using namespace skydrop;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::filesystem::path file = fuzz::inputFile("a.json", data, size);
  fuzz::accepts("a.json", [&] {
    for (const elevation::NamedPlace& place : elevation::readPlaces(file)) {
      fuzz::require(place.place.latitude >= -90 && place.place.latitude <= 90, "a latitude is in its range");
    }
  });
  return 0;
}
