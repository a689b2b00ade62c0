// Villages of the land: where they are, that nothing of them is steep, wet or in the way of strips.
#include "skydrop/terrain/places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "skydrop/terrain/analytic_height_sources.h"
#include "skydrop/terrain/noise_height_source.h"
#include "skydrop/terrain/woods.h"
#include "support/margin.h"

namespace skydrop::terrain {
namespace {

namespace shared = core::shared::f64;

std::shared_ptr<const HeightSource> land() {
  static const auto source = makeNoiseHeightSource({}, 1);
  return source;
}
const Places& places() {
  static const Places found(land(), {});
  return found;
}

double slopeAt(const glm::dvec2& xz) {
  const glm::dvec2 gradient = land()->sample(xz).gradient;
  return std::hypot(gradient.x, gradient.y);
}

template <class F>
void forEachVillage(const F& f) {
  for (int z = -4; z < 4; ++z)
    for (int x = -5; x < 5; ++x)
      if (const auto village = places().village(x, z)) f(*village, x, z);
}

TEST(Places, liveWhereTheLandIsGentle) {
  // A fifth of the cells at least have a village, of several houses each, with fields around most of them.
  int villages = 0, tilled = 0;
  forEachVillage([&](const Village& village, int, int) {
    ++villages;
    EXPECT_GE(village.parts.size(), 5u);
    int crops = 0;
    for (const std::uint32_t row : village.blocks)
      for (int column = 0; column < shared::kFieldBlocks; ++column)
        crops += (row >> (2 * column) & 3u) == shared::kCropBlock;
    tilled += crops > 20;
  });
  EXPECT_GT(villages, 16);
  EXPECT_GT(tilled, villages * 2 / 3);
}

TEST(Places, H01_areTheSameAskedFromAnywhere) {
  // Near the origin, across it, and 1e9 m out, two queries with middles apart find the same villages, roads
  // and buildings bit by bit; each building stands where its village is.
  int compared = 0, differences = 0;
  for (const glm::dvec2& base :
       {glm::dvec2(-3000, 2600), glm::dvec2(0, 0), glm::dvec2(1e9, -1e9), glm::dvec2(-1e9, 7e8)}) {
    const Places one(land(), {}), other(land(), {});
    const PlacesAround a = one.around(base, 4000), b = other.around(base + glm::dvec2(700, -900), 5000);
    for (const auto& village : a.villages) {
      const auto same =
          std::ranges::find_if(b.villages, [&](const auto& v) { return v->middle == village->middle; });
      if (same == b.villages.end() || (*same)->parts.size() != village->parts.size()) {
        ++differences;
        continue;
      }
      differences += (*same)->blocks != village->blocks;
      for (std::size_t i = 0; i < village->parts.size(); ++i) {
        ++compared;
        const HousePart& part = village->parts[i];
        differences += (*same)->parts[i].foot != part.foot || (*same)->parts[i].bits != part.bits;
        EXPECT_LT(std::hypot(part.foot.x - village->middle.x, part.foot.z - village->middle.y), 960);
      }
    }
    for (const auto& road : a.roads) {
      differences += std::ranges::none_of(b.roads, [&](const auto& r) {
        return r->pieces.front().from == road->pieces.front().from &&
               r->pieces.back().to == road->pieces.back().to && r->pieces.size() == road->pieces.size();
      });
    }
  }
  EXPECT_GT(compared, 300);
  EXPECT_TRUE(test::holds("H01", differences, test::atMost(0), "differences"));
}

TEST(Places, H02_nothingIsSteeperThanItMayBe) {
  // Houses, corners of fields, roads between their points: against the exact land. Roads are on land or on
  // decks.
  double house = 0, grade = 0, crossfall = 0, longest = 0;
  int roads = 0;
  forEachVillage([&](const Village& village, int x, int z) {
    for (const HousePart& part : village.parts) {
      if (!part.standsOnLand) continue;
      const glm::dvec2 at(part.foot.x, part.foot.z);
      house = std::max(house, slopeAt(at));
      EXPECT_GT(land()->height(at), 4);
      EXPECT_NEAR(part.landM, land()->height(at), 1e-9);
      // Walls begin over the land at each corner and go on below it.
      for (int k = 0; k < 4; ++k) {
        const glm::dvec2 corner =
            at + part.along * (k % 2 ? 0.5 : -0.5) * part.shape.lengthM +
            glm::dvec2(-part.along.y, part.along.x) * (k < 2 ? 0.5 : -0.5) * part.shape.widthM;
        EXPECT_LT(part.foot.y - part.skirtM, land()->height(corner)) << "a gap below the wall";
        EXPECT_LT(land()->height(corner), part.foot.y + 1.4) << "sunk";
      }
    }
    for (int direction = 0; direction < 4; ++direction) {
      const auto road = places().road(x, z, direction);
      roads += !road->pieces.empty();
      for (const WayPiece& piece : road->pieces) {
        const HeightSample a = land()->sample(piece.from), b = land()->sample(piece.to);
        const double length = glm::distance(piece.from, piece.to);
        longest = std::max(longest, length);
        if (a.height < 1.5 || b.height < 1.5) {
          EXPECT_FALSE(road->decks.empty());
          continue;
        }
        grade = std::max(grade, std::abs(b.height - a.height) / length);
        const glm::dvec2 way = (piece.to - piece.from) / length;
        crossfall = std::max(crossfall, std::abs(b.gradient.x * way.y - b.gradient.y * way.x));
      }
    }
  });
  EXPECT_GT(roads, 8);
  EXPECT_LT(longest, 60);
  EXPECT_LE(house, kMostHouseSlope);
  EXPECT_LE(crossfall, kMostCrossfall);
  EXPECT_TRUE(test::holds("H02", grade, test::atMost(kMostGrade), "m a metre"));
}

TEST(Places, houseOverlapsNoWayAndNoOtherHouse) {
  forEachVillage([&](const Village& village, int, int) {
    for (const HousePart& part : village.parts) {
      if (part.use == shared::kDeck) continue;
      for (const WayPiece& way : village.ways) {
        if (way.kind != WayKind::street) continue;
        EXPECT_GT(shared::awayFromWay({part.foot.x, part.foot.z}, way.from, way.to),
                  0.5 * std::min(part.shape.widthM, part.shape.lengthM) + 2.4)
            << part.use;
      }
    }
  });
}

TEST(Places, leaveStripsFree) {
  // Of the land with strips: no building and no field on what is mown.
  const auto ground = makeLandWithStrips(land(), {.density = 1}, 1);
  const Places settled(ground, {});
  const auto strip = ground->strips()->nearest({0, 0}, 30000);
  ASSERT_TRUE(strip);
  const PlacesAround around = settled.around(strip->middle, 3000);
  for (double along = -300; along <= 300; along += 20) {
    for (const double right : {-20.0, 0.0, 20.0}) {
      const glm::dvec2 xz = strip->world(along, right);
      for (const auto& village : around.villages) {
        EXPECT_EQ(village->blockAt(shared::blocksOf(village->local(xz), village->bits)), shared::kNoBlock);
        for (const HousePart& part : village->parts)
          EXPECT_GT(std::hypot(part.foot.x - xz.x, part.foot.z - xz.y), 30);
      }
    }
  }
}

TEST(Places, keepTreesOffFieldsAndWays) {
  // No tree of the woods stands in a field, in a garden or near a way; without places some do.
  const auto settled = std::make_shared<const Places>(land(), PlacesSettings{});
  const Woods with(land(), 1, false, settled), without(land(), 1, false);
  int before = 0;
  forEachVillage([&](const Village& village, int, int) {
    const PlacesAround around = settled->around(village.middle, 500);
    for (const glm::dvec2& aside : {glm::dvec2(0, 0), glm::dvec2(250, 120), glm::dvec2(-260, 200)}) {
      for (const StandingTree& tree : with.around(village.middle + aside, 60))
        EXPECT_FALSE(around.isSettled({tree.foot.x, tree.foot.z}));
      for (const StandingTree& tree : without.around(village.middle + aside, 60))
        before += around.isSettled({tree.foot.x, tree.foot.z});
    }
  });
  EXPECT_GT(before, 50);
}

TEST(Places, breakWhatTouchesWallOrRoof) {
  // Points inside walls and under the ridge touch; above the ridge and beside the walls by more than the
  // reach do not.
  forEachVillage([&](const Village& village, int, int) {
    const HousePart& part = village.parts.front();
    const auto touches = [&](double along, double across, double up) {
      const glm::dvec2 xz = glm::dvec2(part.foot.x, part.foot.z) + part.along * along +
                            glm::dvec2(-part.along.y, part.along.x) * across;
      const auto hit = places().touching(std::array{glm::dvec3(xz.x, part.foot.y + up, xz.y)}, 0.5);
      return hit && hit->foot == part.foot;
    };
    const double ridge = part.shape.wallM + part.shape.roofM;
    EXPECT_TRUE(touches(0, 0, 1));
    EXPECT_TRUE(touches(0, 0, ridge - 0.2));
    EXPECT_TRUE(touches(0, part.shape.widthM / 2 + 0.3, 1));
    EXPECT_FALSE(touches(0, 0, ridge + 0.7));
    EXPECT_FALSE(touches(0, part.shape.widthM / 2 + 0.7, 1));
    EXPECT_FALSE(touches(0, part.shape.widthM / 2, ridge));
  });
}

TEST(Places, reachNoHigherThanTheySay) {
  forEachVillage([&](const Village& village, int, int) {
    for (const HousePart& part : village.parts) {
      if (!part.standsOnLand) continue;
      EXPECT_LT(part.foot.y + part.shape.wallM + part.shape.roofM - part.landM, kTallestHouseM);
    }
  });
}

TEST(Places, H04_areNowhereWithoutDensityOrWorld) {
  // No density, the sea, places beyond the world, infinite or NaN: nothing, and no fault.
  PlacesSettings none;
  none.density = 0;
  std::size_t found = Places(land(), none).around({0, 0}, 5000).villages.size();
  found += Places(makeFlatSource(-20), {}).around({0, 0}, 5000).villages.size();
  for (const double x : {1e13, -1e13, std::numeric_limits<double>::infinity(), std::nan("")}) {
    found += places().around({x, 0}, 500).villages.size();
    found += places().touching(std::array{glm::dvec3(0, 0, x)}, 2).has_value();
  }
  EXPECT_TRUE(test::holds("H04", static_cast<double>(found), test::atMost(0), "places"));
}

}  // namespace
}  // namespace skydrop::terrain
