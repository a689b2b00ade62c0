// The trees of the land: where they stand, which they are, and what touches them.
#include "skydrop/terrain/woods.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "skydrop/terrain/analytic_height_sources.h"
#include "skydrop/terrain/chunk_grid.h"
#include "skydrop/terrain/noise_height_source.h"
#include "support/margin.h"

namespace skydrop::terrain {
namespace {

namespace shared = core::shared::f64;

std::shared_ptr<const HeightSource> land() {
  static const auto source = makeNoiseHeightSource({}, 1);
  return source;
}

// Places of the shipped land, one in each of many squares.
template <class Visit>
void overPlaces(int side, const Visit& visit) {
  for (int z = -side; z < side; ++z) {
    for (int x = -side; x < side; ++x) visit(glm::dvec2(x * 977.0, z * 1013.0));
  }
}

struct Wood {
  glm::dvec2 middle{0};
  std::vector<StandingTree> trees;
};

// The densest of many looks at the shipped land.
const Wood& dense() {
  static const Wood found = [] {
    Wood best;
    const Woods woods(land(), 1, false);
    overPlaces(6, [&](const glm::dvec2& at) {
      std::vector<StandingTree> trees = woods.around(at, 60);
      if (trees.size() > best.trees.size()) best = {at, std::move(trees)};
    });
    return best;
  }();
  return found;
}

TEST(Woods, standWhereTheLandIsPaintedWithThem) {
  // A square of 120 m of dense woods has most of its 225 trees, and all stand on the land.
  const Wood& wood = dense();
  EXPECT_GT(wood.trees.size(), 120u);
  for (const StandingTree& tree : wood.trees) {
    EXPECT_EQ(tree.foot.y, land()->height({tree.foot.x, tree.foot.z}));
    EXPECT_GT(tree.shape.heightM, 0);
    EXPECT_LE(tree.shape.heightM, kTallestTreeM);
    EXPECT_LE(tree.shape.radiusM, shared::kWidestCrownM);
  }
}

TEST(Woods, haveThreeKindsByHeightAndHue) {
  // Of many looks: all kinds occur, dwarf pines alone high up, none above the tree line or in the sea.
  std::array<int, shared::kTreeKinds> count{};
  const Woods woods(land(), 1, false);
  double highestTall = 0, highest = 0, lowest = 1e9, lowestDwarf = 1e9;
  overPlaces(8, [&](const glm::dvec2& at) {
    for (const StandingTree& tree : woods.around(at, 60)) {
      ++count[static_cast<std::size_t>(tree.shape.kind)];
      const double y = tree.foot.y;
      highest = std::max(highest, y), lowest = std::min(lowest, y);
      if (tree.shape.kind == shared::kDwarfPine)
        lowestDwarf = std::min(lowestDwarf, y);
      else
        highestTall = std::max(highestTall, y);
    }
  });
  for (const int trees : count) EXPECT_GT(trees, 10);
  EXPECT_LT(highest, 900);
  EXPECT_GT(lowest, 4);
  EXPECT_LT(highestTall, 860);
  EXPECT_GT(lowestDwarf, 380);
}

TEST(Woods, areTheSameAskedFromAnywhere) {
  // A tree does not depend on the question: circles that overlap agree about what both hold.
  const Wood& wood = dense();
  const Woods woods(land(), 1, false);
  const std::vector<StandingTree> other = woods.around(wood.middle + glm::dvec2(31, -17), 60);
  int shared = 0;
  for (const StandingTree& tree : other) {
    const auto same = std::ranges::find_if(wood.trees, [&](const auto& t) { return t.foot == tree.foot; });
    if (same == wood.trees.end()) continue;
    ++shared;
    EXPECT_EQ(same->shape.heightM, tree.shape.heightM);
    EXPECT_EQ(same->shape.kind, tree.shape.kind);
  }
  EXPECT_GT(shared, 40);
}

TEST(Woods, thinOutByTheirDensity) {
  // Half the density keeps about half of the trees, each as it was; none keeps none.
  const Wood& wood = dense();
  const std::vector<StandingTree> half = Woods(land(), 0.5, false).around(wood.middle, 60);
  const double share = static_cast<double>(half.size()) / static_cast<double>(wood.trees.size());
  EXPECT_NEAR(share, 0.5, 0.12);
  for (const StandingTree& tree : half) {
    EXPECT_TRUE(std::ranges::any_of(wood.trees, [&](const auto& t) {
      return t.foot == tree.foot && t.shape.heightM == tree.shape.heightM;
    }));
  }
  EXPECT_TRUE(Woods(land(), 0, false).around(wood.middle, 60).empty());
}

TEST(Woods, breakWhatTouchesTrunkOrCrown) {
  // A point in a crown or at a trunk touches, one over the top or beside the crown does not.
  const Wood& wood = dense();
  const Woods woods(land(), 1, false);
  const auto tallest =
      std::ranges::max_element(wood.trees, {}, [](const auto& t) { return t.shape.heightM; });
  const double top = tallest->foot.y + tallest->shape.heightM;
  const auto touches = [&](const glm::dvec3& point) {
    return woods.touching(std::array{point}, 0.5).has_value();
  };
  EXPECT_TRUE(touches(tallest->foot + glm::dvec3(0, 1, 0)));
  EXPECT_TRUE(touches(tallest->foot + glm::dvec3(0.3, 0.7 * tallest->shape.heightM, 0)));
  EXPECT_TRUE(touches({tallest->foot.x, top + 0.4, tallest->foot.z}));
  EXPECT_FALSE(touches({tallest->foot.x, top + 0.6, tallest->foot.z})) << "over the tallest tree around";
  EXPECT_FALSE(touches({tallest->foot.x, top + 500, tallest->foot.z}));
  const Woods none(land(), 0, false);
  EXPECT_FALSE(none.touching(std::array{tallest->foot}, 2).has_value());
}

TEST(Woods, touchIsFoundAsByAskingAllTreesAround) {
  // Against the shapes themselves, over points all through a wood.
  const Wood& wood = dense();
  const Woods woods(land(), 1, false);
  core::RandomStream random{7, 0};
  int touched = 0;
  for (int i = 0; i < 400; ++i) {
    const double x = wood.middle.x + 40 * (random.nextUnit() - 0.5);
    const double z = wood.middle.y + 40 * (random.nextUnit() - 0.5);
    const glm::dvec3 point(x, land()->height({x, z}) + 28 * random.nextUnit(), z);
    bool expected = false;
    for (const StandingTree& tree : wood.trees) {
      const glm::dvec3 from = point - tree.foot;
      if (from.y < 0 || from.y > tree.shape.heightM) continue;
      expected |= std::hypot(from.x, from.z) < shared::treeWidthAt(tree.shape, from.y);
    }
    const bool found = woods.touching(std::array{point}, 1e-6).has_value();
    EXPECT_EQ(found, expected) << i;
    touched += found;
  }
  EXPECT_GT(touched, 20);
}

TEST(Woods, leaveStripsFree) {
  // Nothing stands on a strip, beside it or before its ends.
  const auto ground = makeLandWithStrips(land(), {.density = 1}, 1);
  const Woods woods(ground, 1, false);
  int strips = 0;
  overPlaces(2, [&](const glm::dvec2& at) {
    const auto strip = ground->strips()->nearest(at * 8.0, 8000);
    if (!strip) return;
    ++strips;
    for (const double along : {-500.0, -250.0, 0.0, 250.0, 500.0}) {
      for (const StandingTree& tree : woods.around(strip->world(along, 0), 50))
        ADD_FAILURE() << tree.foot.x << ' ' << tree.foot.z;
    }
  });
  EXPECT_GT(strips, 3);
}

TEST(Woods, V01_areWhereTheyAreAtAnyDistanceAndSign) {
  // Negative coordinates, borders of chunks and 1e7 m out: stems keep to their cells, each cell has one at
  // most, and none stands beyond the world.
  const Woods woods(land(), 1, false);
  int trees = 0;
  for (const glm::dvec2& middle :
       {glm::dvec2(0, 0), glm::dvec2(-960, 960), glm::dvec2(1e7, -1e7), glm::dvec2(-9.6e6, 9.6e6)}) {
    for (const glm::dvec2& aside : {glm::dvec2(0, 0), glm::dvec2(9600, 0), glm::dvec2(0, -19200)}) {
      std::set<std::pair<std::int64_t, std::int64_t>> cells;
      for (const StandingTree& tree : woods.around(middle + aside, 200)) {
        const auto cell = std::pair(static_cast<std::int64_t>(std::floor((tree.foot.x + 2.56) / 8)),
                                    static_cast<std::int64_t>(std::floor((tree.foot.z + 2.56) / 8)));
        EXPECT_TRUE(cells.insert(cell).second) << "two trees in a cell";
        ++trees;
      }
    }
  }
  EXPECT_GT(trees, 300);
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double x : {1e13, infinity, -infinity, std::nan("")}) {
    EXPECT_TRUE(woods.around({x, 0}, 50).empty());
    EXPECT_FALSE(woods.touching(std::array{glm::dvec3(0, 0, x)}, 2).has_value());
  }
  test::noFaults("V01", "trees");
}

TEST(Woods, growByTheBeltsOfTheirLand) {
  // On land of elevation data trees stand to 2260 m, on the endless land to 780 m.
  const auto high = makeFlatSource(1500);
  std::size_t alpine = 0, low = 0;
  for (int i = 0; i < 12; ++i) {
    alpine += Woods(high, 1, true).around({i * 2000.0, 0}, 60).size();
    low += Woods(high, 1, false).around({i * 2000.0, 0}, 60).size();
  }
  EXPECT_GT(alpine, 50u);
  EXPECT_EQ(low, 0u);
  EXPECT_TRUE(Woods(makeFlatSource(-20), 1, false).around({0, 0}, 200).empty()) << "the sea";
}

}  // namespace
}  // namespace skydrop::terrain
