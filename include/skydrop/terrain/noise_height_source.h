// Endless land from hashed gradient noise (docs/terrain-noise.md is the picture, terrain_settings.h the
// parameters).
#pragma once

#include <cstdint>
#include <memory>

#include "skydrop/terrain/height_source.h"
#include "skydrop/terrain/terrain_settings.h"

namespace skydrop::terrain {

// The same settings and seed give the same bits everywhere. Throws core::RangeError when a setting is outside
// its described range. Heights lie inside HeightRange{} for any settings: the last few hundred metres are a
// soft limit. So its range() and storedRange() are always HeightRange{}: one range serves all settings,
// chunks of two worlds decode alike, and the row kernels encode with its constants, whose step is a power of
// two. A source of wider land (a map of the earth) states a range of its own.
std::shared_ptr<const HeightSource> makeNoiseHeightSource(const TerrainSettings& settings,
                                                          std::uint64_t seed);

// The same land without its finest octaves: at most so many are summed of those that are finer than hills
// (five by default, from 256 m down to 16 m). A shorter finestWavelength would be other land, because the
// seeds of gullies follow. For studies of what the octaves cost.
std::shared_ptr<const HeightSource> makeCoarsenedNoiseHeightSource(const TerrainSettings& settings,
                                                                   std::uint64_t seed,
                                                                   std::size_t detailOctaves);

}  // namespace skydrop::terrain
