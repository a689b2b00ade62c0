#include "skydrop/terrain/chunk_data.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "skydrop/core/error.h"
#include "skydrop/terrain/analytic_height_sources.h"
#include "skydrop/terrain/endless_terrain.h"
#include "terrain/patch_bounds.h"

namespace skydrop::terrain {
namespace {

// Of all land on earth: the shore of the Dead Sea to Mount Everest.
constexpr HeightRange kEarth{-430, 8848};

TEST(ChunkData, heightsAreRoundedToTheNearestStep) {
  // A stored height is off by half a step at most (and 1e-9 m of rounding); what lies outside the range takes
  // the nearest end. The step is 1/65535 of the range.
  for (const HeightRange& range : {HeightRange{}, kEarth, HeightRange{-11000, -10999.5}}) {
    ASSERT_EQ(range.step(), (range.highest - range.lowest) / 65535);
    const double stride = (range.highest - range.lowest) / 2634.7;
    for (double h = range.lowest; h < range.highest; h += stride)
      ASSERT_LE(std::abs(range.decode(range.encode(h)) - h), range.step() / 2 + 1e-9);
    EXPECT_EQ(range.encode(-1e9), 0);
    EXPECT_EQ(range.encode(1e9), 65535);
    EXPECT_EQ(range.encode(std::numeric_limits<double>::quiet_NaN()), 0);
    EXPECT_NEAR(range.decode(65535), range.highest, 1e-9);
  }
  EXPECT_EQ(HeightRange{}.decode(HeightRange{}.encode(0)), 0.0) << "sea level is exact in the shipped range";
}

TEST(ChunkData, theShippedRangeDecodesExactlyInFloat) {
  // What the shaders compute, lowest + step * code in float, is the double's value for every code.
  constexpr HeightRange kRange;
  for (unsigned code = 0; code <= 65535; ++code) {
    const auto lowest = static_cast<float>(kRange.lowest), step = static_cast<float>(kRange.step());
    const float onGpu = lowest + step * static_cast<float>(code);
    ASSERT_EQ(static_cast<double>(onGpu), kRange.decode(static_cast<std::uint16_t>(code)));
  }
}

TEST(ChunkData, rangesThatCannotBeStoredAreRefused) {
  // A range that falls, is empty, or is not finite: one line instead of land at NaN.
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const HeightRange& range : {HeightRange{10, 10}, HeightRange{10, -10}, HeightRange{kNan, 10},
                                   HeightRange{0, kNan}, HeightRange{-kInfinity, 0}, HeightRange{0, 2e6}}) {
    EXPECT_THROW(range.requireValid(), core::RangeError) << range.lowest << " to " << range.highest;
    core::JobPool pool(1);
    EXPECT_THROW(EndlessTerrain(makeTiltedPlaneSource(0, {0, 0}, range), pool, {}), core::RangeError);
  }
  EXPECT_NO_THROW(HeightRange{}.requireValid());
  EXPECT_NO_THROW(kEarth.requireValid());
}

TEST(ChunkData, aSourceOfAnotherRangeIsStoredOverItsOwn) {
  // Slopes from the bottom of the range to its top, at two levels: stored heights are the source's within
  // half a step, and the bounds by which chunks and patches are culled hold them.
  const auto plane = makeTiltedPlaneSource(3000, {0.9, -0.2}, kEarth);
  double lowest = 1e9, highest = -1e9;
  for (const ChunkKey key : {ChunkKey{-1, 0, 2}, ChunkKey{1, -1, 2}, ChunkKey{5, 1, 0}}) {
    const ChunkData chunk = makeChunk(*plane, key);
    ASSERT_EQ(chunk.heightRange, kEarth);
    const PatchBounds patches(chunk);
    const glm::dvec2 lo = chunkOrigin(key);
    const HeightBounds ofSource = plane->bounds(lo, lo + chunkMetres(key.level));
    EXPECT_GE(chunk.bounds.lowest, ofSource.lowest - kEarth.step() / 2);
    EXPECT_LE(chunk.bounds.highest, ofSource.highest + kEarth.step() / 2);
    for (int row = 0; row < kChunkSamples; ++row) {
      for (int column = 0; column < kChunkSamples; ++column) {
        const double height = chunk.height(static_cast<std::size_t>(sampleIndex(column, row)));
        ASSERT_NEAR(height, plane->height(lo + glm::dvec2(column, row) * cellMetres(key.level)),
                    kEarth.step() / 2 + 1e-9);
        ASSERT_GE(height, chunk.bounds.lowest);
        ASSERT_LE(height, chunk.bounds.highest);
        const int x = std::min(column / kPatchCells, kPatchesPerChunk - 1);
        const int z = std::min(row / kPatchCells, kPatchesPerChunk - 1);
        const HeightBounds ofPatch = patches.at(0, x, z), ofAll = patches.at(kLodCount - 1, 0, 0);
        ASSERT_GE(height, ofPatch.lowest);
        ASSERT_LE(height, ofPatch.highest);
        ASSERT_EQ(ofAll.lowest, chunk.bounds.lowest);
        ASSERT_EQ(ofAll.highest, chunk.bounds.highest);
        lowest = std::min(lowest, height);
        highest = std::max(highest, height);
      }
    }
  }
  EXPECT_NEAR(lowest, -430, 1e-9) << "the land must reach both ends of the range";
  EXPECT_NEAR(highest, 8848, 1e-9);
}

TEST(ChunkData, theUprightNormalIsExact) {
  // Flat ground and water must not look tilted by the format.
  EXPECT_EQ(decodeNormal(encodeNormal({0, 0})), glm::dvec3(0, 1, 0));
}

TEST(ChunkData, boundsAndSamplesOfATiltedPlaneAreItsOwn) {
  // A plane fills the chunk from corner to corner, and its bounds are its corners.
  const auto plane = makeTiltedPlaneSource(200, {0.125, -0.0625});
  const ChunkData chunk = makeChunk(*plane, {-1, 2, 0});
  ASSERT_FALSE(chunk.empty());
  EXPECT_EQ(chunk.height(0), plane->height({-960, 1920}));
  EXPECT_EQ(chunk.height(static_cast<std::size_t>(sampleIndex(240, 240))), plane->height({0, 2880}));
  EXPECT_EQ(chunk.bounds.lowest, plane->height({-960, 2880}));
  EXPECT_EQ(chunk.bounds.highest, plane->height({0, 1920}));
}

TEST(ChunkData, aStopGivesAnEmptyChunk) {
  // A cancelled job returns nothing that could be mistaken for land.
  std::stop_source stop;
  stop.request_stop();
  EXPECT_TRUE(makeChunk(*makeFlatSource(5), {0, 0, 0}, stop.get_token()).empty());
}

}  // namespace
}  // namespace skydrop::terrain
