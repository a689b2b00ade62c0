// How far each LOD's mesh departs from a chunk's samples.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "skydrop/terrain/chunk_key.h"

namespace skydrop::terrain {

// ChunkData::lodError of these kChunkSamples^2 height codes, metres.
std::array<float, kLodCount> lodErrors(std::span<const std::uint16_t> heights);

}  // namespace skydrop::terrain
