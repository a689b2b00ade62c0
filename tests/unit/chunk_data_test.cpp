#include "skydrop/terrain/chunk_data.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "skydrop/core/hash.h"
#include "skydrop/terrain/analytic_height_sources.h"
#include "terrain/row_kernels.h"

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

TEST(ChunkData, lodErrorsAreThoseOfThePlanesOfTheMesh) {
  // Against every sample's distance to its triangle, on random heights: exact for every instruction set.
  std::vector<std::uint16_t> heights(static_cast<std::size_t>(kChunkSamples) * kChunkSamples);
  core::RandomStream random{5, 0};
  for (int round = 0; round < 4; ++round) {
    // The worst may lie on any row or column: also where only the last ones stand out.
    for (std::uint16_t& code : heights) code = round < 2 ? static_cast<std::uint16_t>(random.next()) : 20000;
    if (round == 2) heights[static_cast<std::size_t>(sampleIndex(kChunkCells, 117))] = 40000;
    if (round == 3) heights[static_cast<std::size_t>(sampleIndex(33, kChunkCells))] = 1000;
    std::array<int, kLodCount> truth{};
    for (std::size_t lod = 1; lod < kLodSkips.size(); ++lod) {
      const int skip = kLodSkips[lod];
      for (int row = 0; row < kChunkSamples; ++row) {
        for (int column = 0; column < kChunkSamples; ++column) {
          const int x0 = std::min(column / skip * skip, kChunkCells - skip);
          const int z0 = std::min(row / skip * skip, kChunkCells - skip);
          const auto at = [&](int dx, int dz) {
            return static_cast<int>(heights[static_cast<std::size_t>(sampleIndex(x0 + dx, z0 + dz))]);
          };
          const int x = column - x0, z = row - z0;
          const int plane =
              x + z <= skip ? at(0, 0) * skip + (at(skip, 0) - at(0, 0)) * x + (at(0, skip) - at(0, 0)) * z
                            : at(skip, skip) * skip + (at(0, skip) - at(skip, skip)) * (skip - x) +
                                  (at(skip, 0) - at(skip, skip)) * (skip - z);
          truth[lod] = std::max(truth[lod], std::abs(at(x, z) * skip - plane));
        }
      }
    }
    for (const InstructionSet set : kInstructionSets) {
      const RowKernels* kernels = rowKernels(set);
      if (kernels == nullptr) continue;
      std::array<int, kLodCount> found{};
      kernels->lodErrors(heights.data(), found.data());
      EXPECT_EQ(found, truth) << "set " << static_cast<int>(set) << " round " << round;
    }
  }
}

TEST(ChunkData, aStopGivesAnEmptyChunk) {
  // A cancelled job returns nothing that could be mistaken for land.
  std::stop_source stop;
  stop.request_stop();
  EXPECT_TRUE(makeChunk(*makeFlatSource(5), {0, 0, 0}, stop.get_token()).empty());
}

}  // namespace
}  // namespace skydrop::terrain
