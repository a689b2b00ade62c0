// DDS textures and volumes: what is accepted comes back from both headers.
#include "skydrop/core/dds.h"

#include "fuzz/fuzz_input.h"

using namespace skydrop;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::accepts("a.dds", [&] {
    const core::TextureData texture = core::decodeDds(fuzz::bytesOf(data, size), "a.dds");
    if (texture.texels.size() > 1 << 16) return;
    const std::vector<std::byte> again = core::encodeDds(texture, core::DdsHeader::dx10);
    fuzz::require(core::decodeDds(again, "a.dds") == texture, "a texture comes back as it was written");
  });
  return 0;
}
