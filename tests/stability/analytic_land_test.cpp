#include <gtest/gtest.h>

#include <cmath>

#include "skydrop/terrain/analytic_height_sources.h"
#include "skydrop/terrain/chunk_data.h"
#include "support/margin.h"

namespace skydrop::terrain {
namespace {

std::size_t at(int column, int row) { return static_cast<std::size_t>(sampleIndex(column, row)); }
std::size_t normalAt(int column, int row) { return static_cast<std::size_t>(normalIndex(column, row)); }

double degreesBetween(const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 off = a - b;
  return 2 * std::asin(0.5 * std::sqrt(off.x * off.x + off.y * off.y + off.z * off.z)) * 57.29578;
}

TEST(Stability, T17_aTiltedPlaneHasItsNormal) {
  // Rising to the east and falling to the south, the normal leans west and south, exactly (1e-6); stored, it
  // is off by the format's 0.6 degrees at most. Signs and scales that noise would hide show here.
  const auto plane = makeTiltedPlaneSource(500, {0.3, -0.2});
  const double length = std::sqrt(0.3 * 0.3 + 0.2 * 0.2 + 1);
  const glm::dvec3 truth(-0.3 / length, 1 / length, 0.2 / length);
  const glm::dvec3 normal = normalOf(plane->sample({12, 34}));
  EXPECT_TRUE(test::holds("T17", test::apart(normal.x, truth.x), test::atMost(1e-6), "of length 1"));
  EXPECT_TRUE(test::holds("T17", test::apart(normal.y, truth.y), test::atMost(1e-6), "of length 1"));
  EXPECT_TRUE(test::holds("T17", test::apart(normal.z, truth.z), test::atMost(1e-6), "of length 1"));
  const ChunkData chunk = makeChunk(*plane, {0, 0, 0});
  const int reach = normalReach(0);
  for (int row = -reach; row < kChunkSamples + reach; ++row) {
    for (int column = -reach; column < kChunkSamples + reach; ++column)
      ASSERT_TRUE(test::holds("T17",
                              degreesBetween(decodeNormal(chunk.normals[normalAt(column, row)]), truth),
                              test::below(0.6), "degrees"));
  }
  // The stored heights rise along the columns and fall along the rows.
  EXPECT_TRUE(test::holds("T17", test::apart(chunk.height(at(100, 0)) - chunk.height(at(0, 0)), 120.0),
                          test::atMost(chunk.heightRange.step()), "m"));
  EXPECT_TRUE(test::holds("T17", test::apart(chunk.height(at(0, 100)) - chunk.height(at(0, 0)), -80.0),
                          test::atMost(chunk.heightRange.step()), "m"));
}

TEST(Stability, T17_storedNormalsAreNeverFarOff) {
  // Over all directions up to slopes of 5 (79 degrees), the format's error stays under 0.6 degrees.
  double worst = 0;
  for (int i = 0; i < 400; ++i) {
    for (int j = 0; j < 400; ++j) {
      const HeightSample sample{0, {(i - 200) * 0.025, (j - 200) * 0.025}};
      worst = std::max(worst, degreesBetween(decodeNormal(encodeNormal(sample.gradient)), normalOf(sample)));
    }
  }
  EXPECT_TRUE(test::holds("T17", worst, test::below(0.6), "degrees"));
}

TEST(Stability, T17_aRidgeIsSymmetric) {
  // A ridge on the chunk's middle column: heights equal, normals mirrored, sample by sample; upright on the
  // crest.
  test::noFaults("T17", "violations");
  const auto ridge = makeRidgeSource(480, 300, 0.5, 0);
  const ChunkData chunk = makeChunk(*ridge, {0, 0, 0});
  for (int row = 0; row < kChunkSamples; row += 16) {
    for (int column = 0; column < kChunkSamples; ++column) {
      const int mirror = kChunkCells - column;
      ASSERT_EQ(chunk.heights[at(column, row)], chunk.heights[at(mirror, row)]);
      const glm::dvec3 west = decodeNormal(chunk.normals[normalAt(column, row)]);
      const glm::dvec3 east = decodeNormal(chunk.normals[normalAt(mirror, row)]);
      ASSERT_EQ(west, glm::dvec3(-east.x, east.y, east.z));
      if (column < kChunkCells / 2) {
        ASSERT_LT(west.x, -0.4);
      }
    }
    EXPECT_EQ(decodeNormal(chunk.normals[normalAt(kChunkCells / 2, row)]), glm::dvec3(0, 1, 0));
    EXPECT_EQ(chunk.height(at(kChunkCells / 2, row)), 300.0);
  }
}

TEST(Stability, T17_aStepStandsWhereItStands) {
  // The sample on the edge belongs to the east; no sample has a height between the two.
  test::noFaults("T17", "violations");
  const auto step = makeStepSource(400, 10, 90);
  const ChunkData chunk = makeChunk(*step, {0, -1, 0});
  for (int row = 0; row < kChunkSamples; ++row) {
    for (int column = 0; column < kChunkSamples; ++column)
      ASSERT_EQ(chunk.height(at(column, row)), column < 100 ? 10.0 : 90.0);
  }
}

}  // namespace
}  // namespace skydrop::terrain
