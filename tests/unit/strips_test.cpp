// Grass strips in the land.
#include "skydrop/terrain/strips.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>
#include <vector>

#include "skydrop/core/hash.h"
#include "skydrop/terrain/analytic_height_sources.h"
#include "skydrop/terrain/chunk_data.h"
#include "skydrop/terrain/noise_height_source.h"

namespace skydrop::terrain {
namespace {

std::shared_ptr<const HeightSource> noise() {
  static const auto source = makeNoiseHeightSource({}, 1);
  return source;
}
std::shared_ptr<const HeightSource> land() {
  static const auto source = makeLandWithStrips(noise(), {.density = 1}, 1);
  return source;
}
Strip first() { return *land()->strips()->nearest({0, 0}, 60000); }

std::vector<Strip> some() {
  std::vector<Strip> all;
  for (int x = -3; x <= 3; ++x) {
    for (int z = -3; z <= 3; ++z) {
      const auto strip = land()->strips()->nearest({x * kStripCell, z * kStripCell}, kStripCell);
      if (!strip) continue;
      if (std::none_of(all.begin(), all.end(), [&](const Strip& s) { return s.middle == strip->middle; }))
        all.push_back(*strip);
    }
  }
  return all;
}

TEST(Strips, areWhereTheSeedSaysAndNotEverywhere) {
  const std::vector<Strip> all = some();
  EXPECT_GE(all.size(), 8u);
  EXPECT_LE(all.size(), 60u);
  const auto again = makeLandWithStrips(noise(), {.density = 1}, 1);
  // Asked in another order: the same to the bit.
  for (auto strip = all.rbegin(); strip != all.rend(); ++strip)
    EXPECT_EQ(again->strips()->nearest(strip->middle, 10)->middle, strip->middle);
  const auto other = makeLandWithStrips(noise(), {.density = 1}, 2);
  EXPECT_FALSE(other->strips()->at(first().middle));
  const auto none = makeLandWithStrips(noise(), {.density = 0}, 1);
  EXPECT_FALSE(none->strips()->nearest({0, 0}, 60000));
}

TEST(Strips, areLevelWithinTwoPerCentAndMadeNoWalls) {
  // On what is mown the land is the plane to 1e-9 m; all around it no slope exceeds that of the land before
  // by more than the blend's 1.875 * 5 / 80, checked every 7 m.
  for (const Strip& strip : some()) {
    EXPECT_LE(std::abs(strip.slope), kMostStripSlope);
    for (double along = -strip.halfLength - 100; along <= strip.halfLength + 100; along += 7) {
      for (double right = -strip.halfWidth - 100; right <= strip.halfWidth + 100; right += 7) {
        const glm::dvec2 at = strip.world(along, right);
        const HeightSample s = land()->sample(at), before = noise()->sample(at);
        ASSERT_LT(glm::length(s.gradient), std::max(glm::length(before.gradient), 0.02) + 0.15);
        if (!strip.contains(at)) continue;
        ASSERT_NEAR(s.height, strip.heightAt(along), 1e-9);
        ASSERT_GT(s.height, 0);
      }
    }
  }
}

TEST(Strips, theGradientIsThatOfTheHeight) {
  // Against central differences over 2 mm, at 20 000 places on and around a strip: within 2e-5.
  const Strip strip = first();
  core::RandomStream random{3, 0};
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec2 at = strip.world((2 * random.nextUnit() - 1) * (strip.halfLength + 110),
                                      (2 * random.nextUnit() - 1) * (strip.halfWidth + 110));
    const HeightSample s = land()->sample(at);
    const double d = 1e-3;
    const glm::dvec2 slope(land()->height(at + glm::dvec2(d, 0)) - land()->height(at - glm::dvec2(d, 0)),
                           land()->height(at + glm::dvec2(0, d)) - land()->height(at - glm::dvec2(0, d)));
    ASSERT_LT(glm::length(slope / (2 * d) - s.gradient), 2e-5)
        << strip.local(at).x << " " << strip.local(at).y;
  }
}

TEST(Strips, awayFromThemNoBitChanges) {
  const Strip strip = first();
  core::RandomStream random{4, 0};
  for (int i = 0; i < 5000; ++i) {
    const glm::dvec2 at(20000 * (random.nextUnit() - 0.5), 20000 * (random.nextUnit() - 0.5));
    if (glm::length(at - strip.middle) < 500) continue;
    const auto near = land()->strips()->nearest(at, 500);
    if (near) continue;
    ASSERT_EQ(land()->sample(at).height, noise()->sample(at).height);
    ASSERT_EQ(land()->sample(at).gradient, noise()->sample(at).gradient);
  }
}

TEST(Strips, chunksOfEveryLevelHaveThem) {
  // The stored height is that of sample() within a step of the code, at every level whose samples hit the
  // strip; where two levels share a place the codes are equal; bounds hold every sample.
  const Strip strip = first();
  for (std::int32_t level = 0; level <= 4; ++level) {
    const ChunkKey key = [&] {
      ChunkKey k{0, 0, level};
      const double metres = chunkMetres(level);
      k.x = static_cast<std::int64_t>(std::floor(strip.middle.x / metres));
      k.z = static_cast<std::int64_t>(std::floor(strip.middle.y / metres));
      return k;
    }();
    const ChunkData chunk = makeChunk(*land(), key), plain = makeChunk(*noise(), key);
    const glm::dvec2 origin = chunkOrigin(key);
    const HeightBounds bounds = land()->bounds(origin, origin + chunkMetres(level));
    int changed = 0, onStrip = 0;
    for (int row = 0; row < kChunkSamples; ++row) {
      for (int column = 0; column < kChunkSamples; ++column) {
        const auto i = static_cast<std::size_t>(sampleIndex(column, row));
        changed += chunk.heights[i] != plain.heights[i] ? 1 : 0;
        const glm::dvec2 at = origin + glm::dvec2(column, row) * cellMetres(level);
        if (!strip.contains(at)) continue;
        ++onStrip;
        ASSERT_NEAR(chunk.height(i), land()->height(at), chunk.heightRange.step()) << level;
        ASSERT_EQ(chunk.normals[static_cast<std::size_t>(normalIndex(column, row))],
                  encodeNormal(strip.slope * strip.along));
      }
    }
    EXPECT_GE(chunk.bounds.lowest, bounds.lowest - chunk.heightRange.step()) << level;
    EXPECT_LE(chunk.bounds.highest, bounds.highest + chunk.heightRange.step()) << level;
    if (level <= 1) {
      EXPECT_GT(onStrip, 100) << level;
      EXPECT_GT(changed, 100) << level;
    }
  }
}

TEST(Strips, theApproachIsFree) {
  for (const Strip& strip : some()) {
    for (double before = 100; before <= kStripApproach; before += 50) {
      const double land = noise()->height(strip.world(-strip.halfLength - before, 0));
      EXPECT_LT(land, strip.heightAt(-strip.halfLength) + 8 + 0.04 * before + 6);
    }
  }
}

TEST(Strips, theSeaAndMountainsHaveNone) {
  EXPECT_FALSE(makeLandWithStrips(makeFlatSource(-10), {.density = 1}, 1)->strips()->nearest({0, 0}, 30000));
  EXPECT_FALSE(makeLandWithStrips(makeTiltedPlaneSource(500, {0.3, 0}), {.density = 1}, 1)
                   ->strips()
                   ->nearest({0, 0}, 4000));
  EXPECT_TRUE(makeLandWithStrips(makeFlatSource(100), {.density = 1}, 1)
                  ->strips()
                  ->at(makeLandWithStrips(makeFlatSource(100), {.density = 1}, 1)
                           ->strips()
                           ->nearest({0, 0}, 30000)
                           ->middle));
}

TEST(Strips, whatIsNotFiniteOrBeyondTheWorldHasNone) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  for (const double x : {std::numeric_limits<double>::quiet_NaN(), kInfinite, -kInfinite, 1e300}) {
    EXPECT_FALSE(land()->strips()->at({x, 0}));
    EXPECT_FALSE(land()->strips()->nearest({0, x}, 60000));
    EXPECT_EQ(land()->height({x, 5}), noise()->height({x, 5}));
  }
}

}  // namespace
}  // namespace skydrop::terrain
