// The star catalogue.
#include "skydrop/sky/stars.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "fuzz/fuzz_input.h"

using namespace skydrop;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::accepts("a.bin", [&] {
    for (const sky::Star& star : sky::decodeStars(fuzz::bytesOf(data, size), "a.bin")) {
      fuzz::require(std::abs(glm::length(star.direction) - 1) < 1e-12, "a direction has length 1");
      fuzz::require(star.magnitude >= -2 && star.magnitude <= 8, "a magnitude is in its range");
    }
  });
  return 0;
}
