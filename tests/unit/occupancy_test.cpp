#include "skydrop/clouds/occupancy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "skydrop/core/hash.h"
#include "support/shared_noise.h"

namespace skydrop::clouds {
namespace {

// Erosion only takes away, so what is judged is the field without it.
CloudSettings uneroded(CloudSettings settings = {}) {
  settings.layers[0].erosion = 0;
  return settings;
}

struct Named {
  const char* name;
  CloudSettings settings;
};

std::vector<Named> corners() {
  std::vector<Named> all{{"default", {}}};
  using Layer = CloudLayerSettings;
  const auto add = [&](const char* name, auto change, double fadeDistance = CloudSettings().fadeDistance) {
    all.push_back({name, {}});
    change(all.back().settings.layers[0]);
    all.back().settings.fadeDistance = fadeDistance;
  };
  add("deck", [](Layer& s) { s.coverage = 1, s.densityThreshold = 0; });
  add("sparse", [](Layer& s) { s.coverage = 0.15, s.densityThreshold = 0.7; });
  add("stratus", [](Layer& s) { s.typeShift = -1, s.coverage = 0.8; });
  add("cumulus", [](Layer& s) { s.typeShift = 1; });
  add("thin and high", [](Layer& s) { s.thickness = 50, s.cloudHeight = 7777, s.coverage = 0.9; });
  add("thick", [](Layer& s) { s.thickness = 6000, s.cloudHeight = 100; });
  add(
      "huge billows, quick weather", [](Layer& s) { s.scale = 0.1, s.weatherScale = 0.1; }, 1000);
  add("small billows, slow weather", [](Layer& s) { s.scale = 4, s.weatherScale = 0.005; });
  add(
      "one shape a period", [](Layer& s) { s.scale = 0.13, s.weatherScale = 0.1; }, 9000);
  for (Named& corner : all) corner.settings = uneroded(corner.settings);
  return all;
}

glm::dvec3 cellSize(const CloudSettings& settings) {
  const double side = weatherPeriod(settings.layers[0], settings.fadeDistance) / Occupancy::kSide;
  return {side, settings.layers[0].thickness / Occupancy::kRows, side};
}

glm::ivec3 randomCell(core::RandomStream& random) {
  return {random.next() % Occupancy::kSide, random.next() % Occupancy::kRows,
          random.next() % Occupancy::kSide};
}

glm::dvec3 within(core::RandomStream& random, const glm::dvec3& low, const glm::dvec3& size) {
  return low + size * glm::dvec3(random.nextUnit(), random.nextUnit(), random.nextUnit());
}

TEST(Occupancy, whereThereIsCloudTheCellIsOccupied) {
  // At random places, also far out and in the drifted field: density means distance 0.
  core::RandomStream random{1, 0};
  for (const auto& [name, settings] : corners()) {
    const Occupancy occupancy(*test::sharedNoise(), settings);
    CloudField field(test::sharedNoise(), settings);
    int clouds = 0;
    for (int i = 0; i < 60000; ++i) {
      const glm::dvec2 drift = i % 3 == 0 ? glm::dvec2(0) : glm::dvec2(1.3e6 * random.nextUnit(), -7e5);
      const double farOut = i % 2 == 0 ? 0 : -1e7;
      field.setDrift(drift);
      const glm::dvec3 place =
          within(random, {farOut, field.layer().cloudHeight, farOut}, {2e5, field.layer().thickness, 2e5});
      if (!(field.density(place) > 0)) continue;
      ++clouds;
      const glm::ivec3 cell = occupancy.cellOf(place - glm::dvec3(drift.x, 0, drift.y));
      ASSERT_EQ(occupancy.distance(cell), 0)
          << name << " at " << place.x << ", " << place.y << ", " << place.z;
    }
    EXPECT_GT(clouds, 20) << name << " proves little";
  }
}

TEST(Occupancy, aDistanceIsABoxOfClearAir) {
  // All cells nearer than the distance, in every axis, hold nothing: what a ray may leap over.
  core::RandomStream random{2, 0};
  for (const auto& [name, settings] : corners()) {
    const Occupancy occupancy(*test::sharedNoise(), settings);
    const CloudField field(test::sharedNoise(), settings);
    const glm::dvec3 size = cellSize(settings);
    const glm::dvec3 origin(0, settings.layers[0].cloudHeight, 0);
    for (int i = 0; i < 60000; ++i) {
      const glm::ivec3 cell = randomCell(random);
      const int distance = occupancy.distance(cell);
      if (distance == 0) continue;
      const glm::dvec3 low = origin + size * glm::dvec3(cell - (distance - 1));
      const glm::dvec3 place = within(random, low, size * (2.0 * distance - 1));
      ASSERT_EQ(field.density(place), 0) << name << ", distance " << distance;
    }
  }
}

TEST(Occupancy, distancesAreThoseOfASearch) {
  // Against looking at every cell around, over the seam too.
  CloudSettings settings;
  settings.layers[0].coverage = 0.2;
  settings.layers[0].densityThreshold = 0.7;
  settings.layers[0].scale = 0.3;
  const Occupancy occupancy(*test::sharedNoise(), settings);
  constexpr int kFarthest = Occupancy::kFarthest;
  const auto searched = [&](const glm::ivec3& cell) {
    int nearest = kFarthest;
    for (int row = 0; row < Occupancy::kRows; ++row) {
      for (int z = -kFarthest; z <= kFarthest; ++z) {
        for (int x = -kFarthest; x <= kFarthest; ++x) {
          const int apart = std::max({std::abs(x), std::abs(z), std::abs(row - cell.y)});
          if (apart < nearest && occupancy.distance({cell.x + x, row, cell.z + z}) == 0) nearest = apart;
        }
      }
    }
    return nearest;
  };
  core::RandomStream random{3, 0};
  std::array<int, kFarthest + 1> seen{};
  for (int i = 0; i < 3000; ++i) {
    glm::ivec3 cell = randomCell(random);
    if (i % 3 == 0) cell.x = cell.x % 2 == 0 ? 0 : Occupancy::kSide - 1;
    if (i % 5 == 0) cell.z = cell.z % 2 == 0 ? 0 : Occupancy::kSide - 1;
    const int distance = occupancy.distance(cell);
    ASSERT_EQ(distance, searched(cell)) << cell.x << ", " << cell.y << ", " << cell.z;
    ++seen[static_cast<std::size_t>(distance)];
  }
  for (const std::size_t distance : {0, 1, 2, 5, 9, 14, kFarthest}) {
    EXPECT_GT(seen[distance], 5) << "too few of distance " << distance;
  }
}

TEST(Occupancy, isNotMuchMoreThanWhatIsThere) {
  // Against the share of cells in which samples a texel apart find cloud: 0.335 against 0.23. The maxima of
  // base and weather need not meet in one place of a cell, so it cannot be equal.
  const CloudSettings settings = uneroded();
  const Occupancy occupancy(*test::sharedNoise(), settings);
  const CloudField field(test::sharedNoise(), settings);
  const glm::dvec3 size = cellSize(settings);
  core::RandomStream random{4, 0};
  constexpr int kCells = 3000;
  int clouds = 0;
  const auto holdsCloud = [&](const glm::ivec3& cell) {
    const glm::dvec3 low = glm::dvec3(0, settings.layers[0].cloudHeight, 0) + size * glm::dvec3(cell);
    for (int k = 0; k < 8 * 5 * 8; ++k) {
      const glm::dvec3 part((k % 8 + 0.5) / 8, (k / 8 % 5 + 0.5) / 5, (k / 40 + 0.5) / 8);
      if (field.density(low + size * part) > 0) return true;
    }
    return false;
  };
  for (int i = 0; i < kCells; ++i) clouds += holdsCloud(randomCell(random));
  const double share = clouds / static_cast<double>(kCells);
  EXPECT_GT(share, 0.1);
  EXPECT_LT(occupancy.occupiedShare(), 1.8 * share) << share;
}

TEST(Occupancy, aClearSkyIsEmpty) {
  // No coverage, no cloud: nothing has to be drawn. Coverage of any share is not empty.
  CloudSettings settings;
  EXPECT_FALSE(Occupancy(*test::sharedNoise(), settings).isEmpty());
  settings.layers[0].coverage = 0;
  const Occupancy clear(*test::sharedNoise(), settings);
  EXPECT_TRUE(clear.isEmpty());
  EXPECT_EQ(clear.occupiedShare(), 0);
  EXPECT_EQ(std::ranges::min(clear.distances()), Occupancy::kFarthest);
}

TEST(Occupancy, cellsCountFromTheOriginAndTheBase) {
  // Columns wrap, rows do not; the last metre before a period is the last cell.
  const CloudSettings settings;
  const Occupancy occupancy(*test::sharedNoise(), settings);
  const glm::dvec3 size = cellSize(settings);
  const double base = settings.layers[0].cloudHeight;
  EXPECT_EQ(occupancy.cellOf({0, base, 0}), glm::ivec3(0, 0, 0));
  EXPECT_EQ(occupancy.cellOf({-1, base - 1, size.z + 1}), glm::ivec3(Occupancy::kSide - 1, -1, 1));
  EXPECT_EQ(occupancy.cellOf({-1e-9, base + settings.layers[0].thickness, 0}).y, Occupancy::kRows);
  EXPECT_EQ(occupancy.distance({-1, 3, Occupancy::kSide}), occupancy.distance({Occupancy::kSide - 1, 3, 0}));
}

}  // namespace
}  // namespace skydrop::clouds
