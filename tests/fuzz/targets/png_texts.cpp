// The texts of a PNG: what is read can be written into another and read again.
#include <algorithm>

#include "fuzz/fuzz_input.h"
#include "skydrop/core/image.h"

using namespace skydrop;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<std::byte> fixed = fuzz::withPngChecksums(fuzz::bytesOf(data, size));
  fuzz::accepts("a.png", [&] {
    std::vector<core::PictureText> texts = core::readPngTexts(fixed, "a.png");
    std::erase_if(texts, [](const core::PictureText& text) {
      return text.keyword.empty() || text.keyword.size() > 79 ||
             !std::ranges::all_of(text.keyword, [](char c) { return c >= 0x20 && c < 0x7f; });
    });
    const std::vector<std::byte> written = core::encodePng(core::Image(1, 1), texts);
    fuzz::require(core::readPngTexts(written, "a.png") == texts, "texts come back as they were written");
  });
  return 0;
}
