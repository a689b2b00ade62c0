#include "terrain/patch_bounds.h"

#include <algorithm>

namespace skydrop::terrain {

PatchBounds::PatchBounds(const ChunkData& chunk) : heightRange_(chunk.heightRange) {
  constexpr int kReachCells = 7;
  for (int step = 0; step < kLodCount; ++step) {
    const int cells = kPatchCells << step, reach = kReachCells << step, patches = kPatchesPerChunk >> step;
    // Rows first, then columns: the extremes of a rectangle are those of its rows' extremes.
    std::vector<Codes> rows(static_cast<std::size_t>(patches) * kChunkSamples);
    for (int z = 0; z < kChunkSamples; ++z) {
      for (int x = 0; x < patches; ++x) {
        const auto first = chunk.heights.begin() + sampleIndex(std::max(x * cells - reach, 0), z);
        const auto last =
            chunk.heights.begin() + sampleIndex(std::min((x + 1) * cells + reach, kChunkCells), z);
        const auto [lowest, highest] = std::minmax_element(first, last + 1);
        rows[static_cast<std::size_t>(x * kChunkSamples + z)] = {*lowest, *highest};
      }
    }
    for (int z = 0; z < patches; ++z) {
      for (int x = 0; x < patches; ++x) {
        Codes codes{0xffff, 0};
        for (int row = std::max(z * cells - reach, 0); row <= std::min((z + 1) * cells + reach, kChunkCells);
             ++row) {
          const Codes& r = rows[static_cast<std::size_t>(x * kChunkSamples + row)];
          codes = {std::min(codes.lowest, r.lowest), std::max(codes.highest, r.highest)};
        }
        codes_[static_cast<std::size_t>(kFirst[static_cast<std::size_t>(step)] + z * patches + x)] = codes;
      }
    }
  }
}

}  // namespace skydrop::terrain
