// Heights that the patches of a chunk can reach, for culling and for their distance to the eye.
#pragma once

#include <array>
#include <vector>

#include "skydrop/terrain/chunk_data.h"
#include "skydrop/terrain/lod.h"

namespace skydrop::terrain {

// A pyramid: step 0 has 16 x 16 patches of one sample's cells, step k those that take every 2^k-th sample,
// step 4 one. The bounds also hold for what morphing makes of a patch: it may reach for samples up to seven
// cells beyond its border (three levels up), within the chunk.
class PatchBounds {
 public:
  explicit PatchBounds(const ChunkData& chunk);

  // step 0 .. kLodCount - 1; x and z from 0 to (16 >> step) - 1.
  HeightBounds at(int step, int x, int z) const {
    const Codes& codes = codes_[static_cast<std::size_t>(kFirst[static_cast<std::size_t>(step)] +
                                                         z * (kPatchesPerChunk >> step) + x)];
    return {heightRange_.decode(codes.lowest), heightRange_.decode(codes.highest)};
  }

 private:
  struct Codes {
    std::uint16_t lowest, highest;
  };
  static constexpr std::array<int, kLodCount> kFirst{0, 256, 320, 336, 340};
  HeightRange heightRange_;
  std::array<Codes, 341> codes_;
};

}  // namespace skydrop::terrain
