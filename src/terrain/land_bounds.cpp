#include "terrain/land_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace skydrop::terrain {
namespace {

// What rounding may add to what the intervals do not direct, metres: heights are below 2^11, so double errors
// of 200 operations stay under 1e-10; chunks round in float to half a millimetre.
constexpr double kRounding = 0.001;

Interval noiseWithin(const Lattice& lattice, glm::dvec2 middle, glm::dvec2 half) {
  const double radius = std::sqrt(half.x * half.x + half.y * half.y) / lattice.cell;
  const Interval all{-1, 1};
  // No slope can be told from any other once the curvature's share alone spans the noise.
  if (0.5 * kNoiseCurvatureLimit * radius * radius >= 2) return all;
  const Jet<double> n = noiseAt(lattice, middle.x, middle.y);
  const double reach =
      std::min(std::abs(n.x) * half.x + std::abs(n.z) * half.y + 0.5 * kNoiseCurvatureLimit * radius * radius,
               kNoiseSlopeLimit * radius);
  return {std::max(n.v - reach, all.lo), std::min(n.v + reach, all.hi)};
}

Interval sumWithin(const std::vector<Lattice>& lattices, glm::dvec2 middle, glm::dvec2 half) {
  Interval total;
  double share = 1;
  for (const Lattice& lattice : lattices) {
    total = total + noiseWithin(lattice, middle, half) * share;
    share *= 0.5;
  }
  return total;
}

}  // namespace

HeightBounds landBounds(const TerrainSettings& settings, const LandShape<double>& shape,
                        const LandOctaves& octaves, glm::dvec2 lo, glm::dvec2 hi) {
  HeightBounds bounds{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
  const glm::dvec2 part = (hi - lo) / static_cast<double>(kBoundsParts);
  const glm::dvec2 half = part * 0.5;
  for (int row = 0; row < kBoundsParts; ++row) {
    for (int column = 0; column < kBoundsParts; ++column) {
      const glm::dvec2 middle = lo + part * glm::dvec2(column + 0.5, row + 0.5);
      LandState<Interval> state = shape.begin(LandFields<Interval>{sumWithin(octaves.continent, middle, half),
                                                                   sumWithin(octaves.range, middle, half),
                                                                   sumWithin(octaves.valley, middle, half)});
      for (std::size_t i = 0; i < octaves.relief.size(); ++i) {
        const int index = static_cast<int>(i);
        shape.octave(noiseWithin(octaves.relief[i], middle, half), ridgeShare(settings, index),
                     detailShare(settings, index), state);
      }
      const Interval height = shape.finish(state);
      bounds.lowest = std::min(bounds.lowest, height.lo - kRounding);
      bounds.highest = std::max(bounds.highest, height.hi + kRounding);
    }
  }
  return bounds;
}

}  // namespace skydrop::terrain
