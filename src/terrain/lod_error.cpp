#include "terrain/lod_error.h"

#include "skydrop/terrain/chunk_data.h"
#include "terrain/row_kernels.h"

namespace skydrop::terrain {

std::array<float, kLodCount> lodErrors(std::span<const std::uint16_t> heights) {
  std::array<int, kLodCount> worst{};
  bestRowKernels().lodErrors(heights.data(), worst.data());
  std::array<float, kLodCount> errors{};
  for (std::size_t lod = 0; lod < errors.size(); ++lod)
    errors[lod] = static_cast<float>(worst[lod] * kHeightStep / kLodSkips[lod]);
  return errors;
}

}  // namespace skydrop::terrain
