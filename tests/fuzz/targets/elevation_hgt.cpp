// Elevation: SRTM tiles. They have one of two sizes, which chance does not hit: the first byte says whether
// the rest is repeated up to the smaller one, the next eleven are the file's name.
#include <algorithm>

#include "fuzz/elevation_input.h"

using namespace skydrop;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kHead = 12, kTile = 2884802;
  if (size <= kHead) return 0;
  std::string name = fuzz::textOf(data + 1, kHead - 1);
  std::ranges::replace_if(
      name, [](char c) { return c < '!' || c == '/' || c == '\x7f'; }, '_');
  std::string content = fuzz::textOf(data + kHead, size - kHead);
  if (data[0] & 1) {
    const std::size_t period = content.size();
    content.resize(kTile);
    for (std::size_t i = period; i < kTile; ++i) content[i] = content[i - period];
  }
  fuzz::readElevation(name, reinterpret_cast<const std::uint8_t*>(content.data()), content.size());
  std::filesystem::remove(fuzz::inputFolder() / name);
  return 0;
}
