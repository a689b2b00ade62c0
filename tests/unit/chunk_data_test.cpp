#include "skydrop/terrain/chunk_data.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "skydrop/terrain/analytic_height_sources.h"

namespace skydrop::terrain {
namespace {

TEST(ChunkData, heightsAreRoundedToTheNearestStep) {
  // A stored height is off by half a step at most; what lies outside the range takes the nearest end.
  for (double h = kLowestHeight; h < kHighestHeight; h += 0.7773)
    ASSERT_LE(std::abs(decodeHeight(encodeHeight(h)) - h), kHeightStep / 2);
  EXPECT_EQ(encodeHeight(-1e9), 0);
  EXPECT_EQ(encodeHeight(1e9), 65535);
  EXPECT_EQ(encodeHeight(std::numeric_limits<double>::quiet_NaN()), 0);
  EXPECT_EQ(decodeHeight(encodeHeight(0)), 0.0);
}

TEST(ChunkData, theUprightNormalIsExact) {
  // Flat ground and water must not look tilted by the format.
  EXPECT_EQ(decodeNormal(encodeNormal({0, 0})), glm::dvec3(0, 1, 0));
}

TEST(ChunkData, boundsAndSamplesOfATiltedPlaneAreItsOwn) {
  // A plane fills the chunk from corner to corner, its bounds are its corners, and every LOD draws it exactly
  // up to the rounding of heights (half a step at each of the two ends compared).
  const auto plane = makeTiltedPlaneSource(200, {0.125, -0.0625});
  const ChunkData chunk = makeChunk(*plane, {-1, 2, 0});
  ASSERT_FALSE(chunk.empty());
  EXPECT_EQ(decodeHeight(chunk.heights[0]), plane->height({-960, 1920}));
  EXPECT_EQ(decodeHeight(chunk.heights[static_cast<std::size_t>(sampleIndex(240, 240))]),
            plane->height({0, 2880}));
  EXPECT_EQ(chunk.bounds.lowest, plane->height({-960, 2880}));
  EXPECT_EQ(chunk.bounds.highest, plane->height({0, 1920}));
  for (float error : chunk.lodError) EXPECT_LE(error, kHeightStep);
}

TEST(ChunkData, lodErrorIsTheWorstDistanceToTheMesh) {
  // A crest at x = 100 m is a vertex of the 4 m mesh and of no other: the coarser ones cut it off.
  const auto ridge = makeRidgeSource(100, 200, 0.5, 0);
  const ChunkData chunk = makeChunk(*ridge, {0, 0, 0});
  EXPECT_EQ(chunk.lodError[0], 0.0f);
  EXPECT_EQ(chunk.lodError[1], 2.0f);  // vertices at 96 and 104 m, both 2 m below the crest
  EXPECT_EQ(chunk.lodError[2],
            3.0f);  // vertices at 96 and 112 m, 198 and 194 m high: 197 m where the crest is
}

TEST(ChunkData, aStopGivesAnEmptyChunk) {
  // A cancelled job returns nothing that could be mistaken for land.
  std::stop_source stop;
  stop.request_stop();
  EXPECT_TRUE(makeChunk(*makeFlatSource(5), {0, 0, 0}, stop.get_token()).empty());
}

}  // namespace
}  // namespace skydrop::terrain
