#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include "skydrop/core/hash.h"
#include "skydrop/terrain/chunk_grid.h"
#include "stability/checks.h"

namespace skydrop::stability {

// The exact floor through integers: floor(x / n) = floor(floor(x) / n) for a positive integer n.
double wrongChunkIndices() {
  core::RandomStream random{4, 0};
  int wrong = 0;
  for (int i = 0; i < 1000000; ++i) {
    const double distance = std::pow(10.0, random.nextUnit() * 18.0 - 3.0);
    const double metres = random.next() & 1 ? distance : -distance;
    const auto whole = static_cast<std::int64_t>(std::floor(metres));
    for (const std::int64_t size : {std::int64_t{60}, std::int64_t{960}, std::int64_t{960 * 64}}) {
      const std::int64_t exact = whole / size - (whole % size < 0 ? 1 : 0);
      wrong += terrain::gridIndex(metres, static_cast<double>(size)) != exact;
    }
  }
  return wrong;
}

double fullestBucketOfHashes() {
  int fullest = 0;
  for (const std::int64_t centre : {std::int64_t{0}, std::int64_t{1} << 31, -(std::int64_t{1} << 40)}) {
    for (const std::int32_t level : {0, 3}) {
      std::vector<int> low(1024), high(1024);
      for (std::int64_t x = centre - 10; x <= centre + 10; ++x) {
        for (std::int64_t z = centre - 10; z <= centre + 10; ++z) {
          const std::uint64_t hash = hashOf(terrain::ChunkKey{x, z, level});
          fullest = std::max({fullest, ++low[hash & 1023], ++high[hash >> 54]});
        }
      }
    }
  }
  return fullest;
}

}  // namespace skydrop::stability
