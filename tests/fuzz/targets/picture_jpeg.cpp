// Photographs: JPEG, or whatever else the first bytes say.
#include "fuzz/fuzz_input.h"
#include "skydrop/core/picture_file.h"

using namespace skydrop;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::accepts("a.jpg", [&] {
    const core::Image image = core::decodePicture(fuzz::bytesOf(data, size), "a.jpg");
    fuzz::require(image.rgba.size() == std::size_t{4} * image.width * image.height, "each pixel is there");
  });
  return 0;
}
