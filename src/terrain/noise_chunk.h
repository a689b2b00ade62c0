// Chunks of the noise land, row by row.
#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "skydrop/terrain/chunk_data.h"
#include "terrain/land_octaves.h"
#include "terrain/row_kernels.h"

namespace skydrop::terrain {

// HeightSource::fillChunk for the land of this shape and these octaves, which belong together; fillWideChunk
// with `wideHeights`, which may be null.
bool fillNoiseChunk(const LandShape<float>& shape, const LandOctaves& octaves, const RowKernels& kernels,
                    const ChunkKey& key, const std::stop_token& stop, ChunkData& out,
                    std::vector<std::uint16_t>* wideHeights);

}  // namespace skydrop::terrain
