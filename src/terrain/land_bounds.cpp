#include "terrain/land_bounds.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "terrain/land_point.h"

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

struct Rectangle {
  glm::dvec2 middle, half;
};

LandState<Interval> uncarvedWithin(const LandShape<double>& shape, const LandOctaves& octaves,
                                   const Rectangle& r) {
  LandFields<Interval> fields{sumWithin(octaves.continent, r.middle, r.half),
                              sumWithin(octaves.range, r.middle, r.half),
                              sumWithin(octaves.crest, r.middle, r.half),
                              sumWithin(octaves.valley, r.middle, r.half),
                              {}};
  for (std::size_t i = 0; i < kHillOctaves; ++i)
    fields.hills[i] = noiseWithin(octaves.hills[i], r.middle, r.half);
  return shape.begin(fields);
}

Interval gullyWithin(const LandShape<double>& shape, const LandOctaves& octaves, std::size_t octave,
                     const Rectangle& r) {
  const Lattice& lattice = octaves.gullies[octave];
  const glm::dvec2 offset{lattice.offsetX, lattice.offsetZ};
  const glm::dvec2 middle = r.middle / lattice.cell + offset, half = r.half / lattice.cell;
  const glm::dvec2 first = glm::floor(middle - half), last = glm::floor(middle + half) + 1.0;
  constexpr double kNodesAtATime = 12;
  double most = 0;
  if ((last.x - first.x + 1) * (last.y - first.y + 1) > kNodesAtATime) {
    // Too many to ask: the strength at any of them.
    const Rectangle around{r.middle, r.half + glm::dvec2(lattice.cell)};
    most = kGullyDepth * std::max(0.0, uncarvedWithin(shape, octaves, around).strength.hi);
  } else {
    for (double j = first.y; j <= last.y; ++j) {
      for (double i = first.x; i <= last.x; ++i) {
        most = std::max(most, gullyNodeAt(shape, octaves, octave, static_cast<std::int64_t>(i),
                                          static_cast<std::int64_t>(j))
                                  .amplitude);
      }
    }
  }
  return Interval{-1, kGullyCrest} * (most * kGullies[octave].metres);
}

}  // namespace

HeightBounds landBounds(const LandShape<double>& shape, const LandOctaves& octaves, glm::dvec2 lo,
                        glm::dvec2 hi) {
  HeightBounds bounds{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
  const glm::dvec2 part = (hi - lo) / static_cast<double>(kBoundsParts);
  for (int row = 0; row < kBoundsParts; ++row) {
    for (int column = 0; column < kBoundsParts; ++column) {
      const Rectangle r{lo + part * glm::dvec2(column + 0.5, row + 0.5), part * 0.5};
      LandState<Interval> state = uncarvedWithin(shape, octaves, r);
      for (std::size_t octave = 0; octave < kGullies.size(); ++octave)
        state.height = state.height + gullyWithin(shape, octaves, octave, r);
      state.detail = sumWithin(octaves.details, r.middle, r.half);
      const Interval height = shape.finish(state);
      bounds.lowest = std::min(bounds.lowest, height.lo - kRounding);
      bounds.highest = std::max(bounds.highest, height.hi + kRounding);
    }
  }
  return bounds;
}

}  // namespace skydrop::terrain
