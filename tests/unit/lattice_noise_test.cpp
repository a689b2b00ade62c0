#include "terrain/lattice_noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace skydrop::terrain {
namespace {

TEST(LatticeNoise, noiseStaysWithinTheBoundsThatCullingReliesOn) {
  // A million pairs of points up to a tenth of a cell apart: values within [-1, 1], slopes and what is left
  // after value and slope within their limits. The limits are worst cases over all gradients, which chance
  // comes near: above 60 % of each is seen.
  const Lattice lattice = makeLattice(64, 0, 9);
  core::RandomStream random{3, 0};
  double worstValue = 0, worstSlope = 0, worstCurvature = 0;
  for (int i = 0; i < 1000000; ++i) {
    const double x = (random.nextUnit() - 0.5) * 1e6, z = (random.nextUnit() - 0.5) * 1e6;
    const double dx = (random.nextUnit() - 0.5) * 9, dz = (random.nextUnit() - 0.5) * 9;
    const Jet<double> here = noiseAt(lattice, x, z), there = noiseAt(lattice, x + dx, z + dz);
    const double distance2 = (dx * dx + dz * dz) / (64.0 * 64.0);
    if (distance2 < 1e-4) continue;
    worstValue = std::max(worstValue, std::abs(here.v));
    worstSlope = std::max(worstSlope, 64 * std::sqrt(here.x * here.x + here.z * here.z));
    worstCurvature =
        std::max(worstCurvature, std::abs(there.v - here.v - here.x * dx - here.z * dz) * 2 / distance2);
  }
  EXPECT_LE(worstValue, 1.0);
  EXPECT_GT(worstValue, 0.8);
  EXPECT_LE(worstSlope, kNoiseSlopeLimit);
  EXPECT_GT(worstSlope, 0.6 * kNoiseSlopeLimit);
  EXPECT_LE(worstCurvature, kNoiseCurvatureLimit);
  EXPECT_GT(worstCurvature, 0.6 * kNoiseCurvatureLimit);
}

TEST(LatticeNoise, directionsAreUnitVectorsOfAllAngles) {
  // Length 1 within float rounding, and each of 64 sectors holds its share of 64 000 within 15 % (five
  // standard deviations).
  int sectors[64] = {};
  for (std::uint64_t i = 0; i < 64000; ++i) {
    const NodeGradient g = directionOf(core::mix64(i));
    ASSERT_NEAR(g.x * g.x + g.z * g.z, 1.0f, 1e-6f);
    const double angle = std::atan2(g.z, g.x) / 6.2831853071795864 + 0.5;
    ++sectors[std::min(63, static_cast<int>(angle * 64))];
  }
  for (const int count : sectors) EXPECT_NEAR(count, 1000, 150);
}

}  // namespace
}  // namespace skydrop::terrain
