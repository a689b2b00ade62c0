// Chunks of the noise land, row by row.
#pragma once

#include <stop_token>

#include "skydrop/terrain/chunk_data.h"
#include "terrain/land_octaves.h"
#include "terrain/row_kernels.h"

namespace skydrop::terrain {

// HeightSource::fillChunk for the land of this shape and these octaves. `shape` and `octaves` belong
// together.
bool fillNoiseChunk(const LandShape<float>& shape, const LandOctaves& octaves, const RowKernels& kernels,
                    const ChunkKey& key, const std::stop_token& stop, ChunkData& out);

}  // namespace skydrop::terrain
