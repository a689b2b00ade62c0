#include "skydrop/terrain/chunk_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <vector>

#include "support/margin.h"

namespace skydrop::terrain {
namespace {

// The exact floor of metres / (60 * 2^k), through integers: metres is split into mantissa and exponent.
std::int64_t exactIndex(double metres, std::int64_t size) {
  const double whole =
      std::floor(metres);  // exact; floor(x / n) = floor(floor(x) / n) for a positive integer n
  const auto i = static_cast<std::int64_t>(whole);
  return i / size - (i % size < 0 ? 1 : 0);
}

void expectExact(double metres) {
  for (const std::int64_t size : {std::int64_t{60}, std::int64_t{960}, std::int64_t{960 * 64}}) {
    ASSERT_EQ(gridIndex(metres, static_cast<double>(size)), exactIndex(metres, size))
        << std::hexfloat << metres << " size " << size;
  }
}

TEST(Stability, T04_chunkIndexIsTheExactFloorOnAndBesideEveryBorder) {
  // On a border, one unit in the last place beside it and a micrometre beside it, from 0 to 1e12 m and beyond
  // 2^31 chunks: the index is the floor.
  test::noFaults("T04", "violations");
  const double kInfinity = std::numeric_limits<double>::infinity();
  for (const std::int64_t chunk :
       {std::int64_t{0}, std::int64_t{1}, std::int64_t{2083}, std::int64_t{1} << 31,
        (std::int64_t{1} << 31) + 1, (std::int64_t{1} << 33) - 1, std::int64_t{1041666667}}) {
    for (const std::int64_t sign : {1, -1}) {
      const double border = static_cast<double>(sign * chunk) * 960.0;
      for (const double x : {border, std::nextafter(border, kInfinity), std::nextafter(border, -kInfinity),
                             border - 1e-6, border + 1e-6}) {
        expectExact(x);
      }
    }
  }
  EXPECT_EQ(chunkAt({-1e-6, 0.0}), (ChunkKey{-1, 0, 0}));
  EXPECT_EQ(chunkAt({-960.0, 959.999}), (ChunkKey{-1, 0, 0}));
  EXPECT_EQ(chunkAt({1e12, -1e12}), (ChunkKey{1041666666, -1041666667, 0}));
  EXPECT_EQ(chunkAt({960.0 * 0x1p31, 0.0}).x, std::int64_t{1} << 31);
}

TEST(Stability, T04_chunkIndexIsTheExactFloorAtRandomPositions) {
  // A million positions, uniform in the logarithm of their distance from 1 mm to 1e15 m.
  EXPECT_TRUE(test::holdsLive("T04"));
}

TEST(Stability, T04_parentCoversItsFourChildren) {
  // Also for negative indices: the parent of a child is the chunk that the child was made from.
  test::noFaults("T04", "violations");
  for (const ChunkKey key : {ChunkKey{0, 0, 1}, ChunkKey{-1, -1, 1}, ChunkKey{-7, 5, 3}}) {
    for (int quadrant = 0; quadrant < 4; ++quadrant) {
      const ChunkKey child = childOf(key, quadrant);
      EXPECT_EQ(parentOf(child), key);
      EXPECT_EQ(chunkAt(chunkOrigin(child), key.level), key);
    }
  }
}

TEST(Stability, T21_hashesOfNeighbouringChunksDifferAndSpread) {
  // 441 neighbouring keys, near the origin and far out: 441 values, and no crowded bucket. With 441 random
  // values in 1024 buckets, more than 6 in one bucket has a probability of 1e-4.
  EXPECT_TRUE(test::holdsLive("T21"));
  for (const std::int64_t centre : {std::int64_t{0}, std::int64_t{1} << 31, -(std::int64_t{1} << 40)}) {
    for (const std::int32_t level : {0, 3}) {
      std::set<std::uint64_t> values;
      for (std::int64_t x = centre - 10; x <= centre + 10; ++x) {
        for (std::int64_t z = centre - 10; z <= centre + 10; ++z) {
          values.insert(hashOf(ChunkKey{x, z, level}));
        }
      }
      EXPECT_EQ(values.size(), 441u);
    }
  }
}

}  // namespace
}  // namespace skydrop::terrain
