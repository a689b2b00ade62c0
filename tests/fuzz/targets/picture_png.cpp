// PNG pictures, with the checksums that the file has and with those that it should have.
#include "fuzz/fuzz_input.h"
#include "skydrop/core/image.h"

using namespace skydrop;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<std::byte> fixed = fuzz::withPngChecksums(fuzz::bytesOf(data, size));
  for (const std::span<const std::byte> png :
       {fuzz::bytesOf(data, size), std::span<const std::byte>(fixed)}) {
    fuzz::accepts("a.png", [&] {
      const core::Image image = core::decodePng(png, "a.png");
      fuzz::require(image.rgba.size() == std::size_t{4} * image.width * image.height, "each pixel is there");
    });
  }
  return 0;
}
