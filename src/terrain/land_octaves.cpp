#include "terrain/land_octaves.h"

#include <atomic>
#include <cmath>

#include "terrain/land_gully.h"
#include "terrain/land_point.h"

namespace skydrop::terrain {
namespace {

LandOctaves makeWorld(const TerrainSettings& s, std::uint64_t seed) {
  std::uint64_t counter = 0;
  const auto chain = [&](double coarsest, double finest) {
    std::vector<Lattice> lattices;
    for (double cell = roundToPowerOfTwo(coarsest); cell >= finest; cell /= 2) {
      lattices.push_back(
          makeLattice(cell, static_cast<int>(lattices.size()), core::hashCombine(seed, counter++)));
    }
    return lattices;
  };
  LandOctaves octaves;
  octaves.continent = chain(s.continentWavelength, roundToPowerOfTwo(s.continentWavelength) / 8);
  octaves.range = chain(s.rangeWavelength, roundToPowerOfTwo(s.rangeWavelength) / 2);
  octaves.crest = chain(2 * roundToPowerOfTwo(s.rangeWavelength), roundToPowerOfTwo(s.rangeWavelength) / 2);
  octaves.valley = chain(s.valleyWavelength, roundToPowerOfTwo(s.valleyWavelength) / 4);
  octaves.hills = chain(s.mountainWavelength, roundToPowerOfTwo(s.mountainWavelength) / 8);
  octaves.details = chain(octaves.hills.back().cell / 2, roundToPowerOfTwo(s.finestWavelength));
  octaves.gullies = chain(kGullies.front().cell, kGullies.back().cell);
  static std::atomic<std::uint64_t> made{0};
  octaves.id = ++made;
  return octaves;
}

constexpr int kWorldsPerSeed = 100;  // about one in six will do

bool flightMayBeginAtOrigin(const TerrainSettings& settings, const LandOctaves& octaves) {
  const LandShape<double> shape(settings);
  const Jet<double> origin = landAt(shape, octaves, {0, 0});
  if (origin.v < 5 || origin.v > 250 || origin.x * origin.x + origin.z * origin.z > 0.04) return false;
  int dry = 0, high = 0;
  for (int row = -3; row <= 3; ++row) {
    for (int column = -3; column <= 3; ++column) {
      const double height = landAt(shape, octaves, glm::dvec2(column, row) * 2000.0).v;
      dry += height > 0;
      high += height > 500;
    }
  }
  return dry >= 40 && high >= 4 && high <= 16;
}

}  // namespace

double roundToPowerOfTwo(double metres) {
  int exponent = 0;
  const double mantissa = std::frexp(metres, &exponent);  // [1/2, 1)
  return std::ldexp(mantissa < 0.70710678118654752 ? 0.5 : 1.0, exponent);
}

LandOctaves makeLandOctaves(const TerrainSettings& settings, std::uint64_t seed) {
  LandOctaves first = makeWorld(settings, core::hashCombine(seed, 0));
  if (flightMayBeginAtOrigin(settings, first)) return first;
  for (std::uint64_t world = 1; world < kWorldsPerSeed; ++world) {
    LandOctaves octaves = makeWorld(settings, core::hashCombine(seed, world));
    if (flightMayBeginAtOrigin(settings, octaves)) return octaves;
  }
  return first;
}

}  // namespace skydrop::terrain
