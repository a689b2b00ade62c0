// Anvils hang together with towers: the reach of a weather map's coverage.
#include "skydrop/clouds/anvil_reach.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "support/shared_noise.h"

namespace skydrop::clouds {
namespace {

// Texels above a level that no way over such texels joins to a seed; the map repeats.
template <class Above, class Seed>
int apart(int side, Above above, Seed seed) {
  std::vector<char> seen(static_cast<std::size_t>(side) * side, 0);
  std::vector<int> open;
  for (int at = 0; at < side * side; ++at)
    if (seed(at)) seen[static_cast<std::size_t>(at)] = 1, open.push_back(at);
  while (!open.empty()) {
    const int at = open.back(), x = at % side, y = at / side;
    open.pop_back();
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const int to = ((y + dy + side) % side) * side + (x + dx + side) % side;
        if (seen[static_cast<std::size_t>(to)] || !above(to)) continue;
        seen[static_cast<std::size_t>(to)] = 1, open.push_back(to);
      }
    }
  }
  int count = 0;
  for (int at = 0; at < side * side; ++at) count += above(at) && !seen[static_cast<std::size_t>(at)];
  return count;
}

TEST(AnvilReach, fallsEvenlyWithTheDistanceFromATower) {
  // One tower of .9: within 3 % of the way's loss all round, over the border of the map too.
  constexpr int kSide = 64;
  std::vector<glm::vec3> map(kSide * kSide, glm::vec3(0));
  map[3 * kSide + 60].x = 0.9f;
  const std::vector<float> reach = anvilReach(map, kSide);
  for (int dy = -20; dy <= 20; dy += 4) {
    for (int dx = -20; dx <= 20; dx += 5) {
      const int at = ((3 + dy + kSide) % kSide) * kSide + (60 + dx) % kSide;
      const float way = std::hypot(static_cast<float>(dx), static_cast<float>(dy));
      EXPECT_NEAR(reach[static_cast<std::size_t>(at)], 0.9f - kAnvilLossATexel * way,
                  0.03f * kAnvilLossATexel * way + 1e-5f)
          << dx << ' ' << dy;
    }
  }
}

TEST(AnvilReach, noAnvilStandsWithoutATower) {
  // On the map of the game, at covers from few towers to many: whatever has an anvil is joined to a place
  // that has the tower. With a cover spread by a factor instead there are many that are not.
  const auto noise = test::sharedNoise();
  const int side = noise->weatherSide;
  int detachedBefore = 0;
  for (const float level : {0.55f, 0.62f, 0.7f, 0.8f}) {
    const auto coverage = [&](int at) { return noise->weather[static_cast<std::size_t>(at)].x; };
    const auto isTower = [&](int at) { return coverage(at) > level; };
    const int detached = apart(
        side, [&](int at) { return noise->anvils[static_cast<std::size_t>(at)] > level; }, isTower);
    EXPECT_EQ(detached, 0) << level;
    detachedBefore += apart(
        side, [&](int at) { return 1.37f * coverage(at) > level; }, isTower);
  }
  std::printf("with a factor %d texels of anvils had no tower\n", detachedBefore);
  EXPECT_GT(detachedBefore, 100) << "proves little";
}

}  // namespace
}  // namespace skydrop::clouds
