// The lattices that the land is summed from.
#pragma once

#include <cstdint>
#include <vector>

#include "skydrop/terrain/terrain_settings.h"
#include "terrain/lattice_noise.h"

namespace skydrop::terrain {

// Chains of octaves, the coarsest first; each cell is half the one before, each amplitude too. Hills are
// kHillOctaves, gullies one for each of kGullies; details go on where the hills end.
struct LandOctaves {
  std::vector<Lattice> continent, range, crest, valley, hills, details, gullies;
  std::uint64_t id = 0;  // differs from that of any other octaves made by this process
};

// The power of two that a wavelength is rounded to, m > 0. By the exponent's bits, not by libm: the same on
// every machine.
double roundToPowerOfTwo(double metres);

// Of the worlds that a seed numbers, the first whose origin is a good place to begin a flight: plain land,
// most of it dry for 6 km around, with mountains in sight. Where settings leave no such place, the first
// world.
LandOctaves makeLandOctaves(const TerrainSettings& settings, std::uint64_t seed);

}  // namespace skydrop::terrain
