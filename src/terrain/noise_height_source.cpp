#include "skydrop/terrain/noise_height_source.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "skydrop/core/error.h"
#include "skydrop/terrain/chunk_data.h"
#include "terrain/land_shape.h"
#include "terrain/lattice_noise.h"

namespace skydrop::terrain {
namespace {

// By the exponent's bits, not by libm: the same on every machine.
double roundToPowerOfTwo(double metres) {
  int exponent = 0;
  const double mantissa = std::frexp(metres, &exponent);  // [1/2, 1)
  return std::ldexp(mantissa < 0.70710678118654752 ? 0.5 : 1.0, exponent);
}

struct Octaves {
  std::vector<Lattice> continent, range, valley, relief;
};

Octaves makeOctaves(const TerrainSettings& s, std::uint64_t seed) {
  std::uint64_t counter = 0;
  const auto chain = [&](double coarsest, double finest) {
    std::vector<Lattice> lattices;
    for (double cell = roundToPowerOfTwo(coarsest); cell >= finest; cell /= 2)
      lattices.push_back(makeLattice(cell, core::hashCombine(seed, counter++)));
    return lattices;
  };
  Octaves octaves;
  octaves.continent = chain(s.continentWavelength, roundToPowerOfTwo(s.continentWavelength) / 8);
  octaves.range = chain(s.rangeWavelength, roundToPowerOfTwo(s.rangeWavelength) / 2);
  octaves.valley = chain(s.valleyWavelength, roundToPowerOfTwo(s.valleyWavelength) / 4);
  octaves.relief = chain(s.mountainWavelength, roundToPowerOfTwo(s.finestWavelength));
  return octaves;
}

// NaN becomes 0.
double insideWorld(double metres) {
  if (!(metres > -kWorldLimitMetres)) return metres == metres ? -kWorldLimitMetres : 0.0;
  return metres < kWorldLimitMetres ? metres : kWorldLimitMetres;
}

class NoiseHeightSource final : public HeightSource {
 public:
  NoiseHeightSource(const TerrainSettings& settings, std::uint64_t seed)
      : shape_(settings), octaves_(makeOctaves(settings, seed)) {}

  HeightSample sample(glm::dvec2 xz) const override {
    const double x = insideWorld(xz.x), z = insideWorld(xz.y);
    const auto sum = [&](const std::vector<Lattice>& lattices) {
      Jet<double> total;
      double share = 1;
      for (const Lattice& lattice : lattices) {
        total = total + noiseAt(lattice, x, z) * share;
        share *= 0.5;
      }
      return total;
    };
    LandState<Jet<double>> state = shape_.begin(
        LandFields<Jet<double>>{sum(octaves_.continent), sum(octaves_.range), sum(octaves_.valley)});
    double share = 1;
    for (const Lattice& lattice : octaves_.relief) {
      shape_.octave(noiseAt(lattice, x, z), share, state);
      share *= 0.5;
    }
    const Jet<double> height = shape_.finish(state);
    return {height.v, {height.x, height.z}};
  }

  HeightBounds bounds(glm::dvec2, glm::dvec2) const override { return range(); }
  HeightBounds range() const override { return {kLowestHeight, kHighestHeight}; }

 private:
  LandShape<double> shape_;
  Octaves octaves_;
};

}  // namespace

std::shared_ptr<const HeightSource> makeNoiseHeightSource(const TerrainSettings& settings,
                                                          std::uint64_t seed) {
  return std::make_shared<NoiseHeightSource>(settings, seed);
}

}  // namespace skydrop::terrain
