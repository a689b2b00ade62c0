// The noise land with a chosen instruction set: for tests and benchmarks.
#pragma once

#include "skydrop/terrain/noise_height_source.h"
#include "terrain/row_kernels.h"

namespace skydrop::terrain {

std::shared_ptr<const HeightSource> makeNoiseHeightSource(const TerrainSettings& settings, std::uint64_t seed,
                                                          const RowKernels& kernels);

}  // namespace skydrop::terrain
