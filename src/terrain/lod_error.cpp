#include "terrain/lod_error.h"

#include <algorithm>
#include <cstdlib>

#include "skydrop/terrain/chunk_data.h"

namespace skydrop::terrain {

std::array<float, kLodCount> lodErrors(std::span<const std::uint16_t> heights) {
  const auto at = [&](int column, int row) {
    return static_cast<int>(heights[static_cast<std::size_t>(sampleIndex(column, row))]);
  };
  std::array<float, kLodCount> errors{};
  for (std::size_t lod = 1; lod < kLodSkips.size(); ++lod) {
    const int skip = kLodSkips[lod];
    int worst = 0;  // height steps times skip: whole numbers, so the result is exact
    for (int z0 = 0; z0 < kChunkCells; z0 += skip) {
      for (int x0 = 0; x0 < kChunkCells; x0 += skip) {
        const int h00 = at(x0, z0), h10 = at(x0 + skip, z0), h01 = at(x0, z0 + skip),
                  h11 = at(x0 + skip, z0 + skip);
        for (int z = 0; z <= skip; ++z) {
          for (int x = 0; x <= skip; ++x) {
            const int plane = x + z <= skip
                                  ? h00 * skip + (h10 - h00) * x + (h01 - h00) * z
                                  : h11 * skip + (h01 - h11) * (skip - x) + (h10 - h11) * (skip - z);
            worst = std::max(worst, std::abs(at(x0 + x, z0 + z) * skip - plane));
          }
        }
      }
    }
    errors[lod] = static_cast<float>(worst * kHeightStep / skip);
  }
  return errors;
}

}  // namespace skydrop::terrain
