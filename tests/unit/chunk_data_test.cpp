#include "skydrop/terrain/chunk_data.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
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
  // A plane fills the chunk from corner to corner, and its bounds are its corners.
  const auto plane = makeTiltedPlaneSource(200, {0.125, -0.0625});
  const ChunkData chunk = makeChunk(*plane, {-1, 2, 0});
  ASSERT_FALSE(chunk.empty());
  EXPECT_EQ(decodeHeight(chunk.heights[0]), plane->height({-960, 1920}));
  EXPECT_EQ(decodeHeight(chunk.heights[static_cast<std::size_t>(sampleIndex(240, 240))]),
            plane->height({0, 2880}));
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
