// Trees in the way of the aircraft.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "skydrop/game/autopilot.h"
#include "skydrop/game/world.h"
#include "skydrop/terrain/noise_height_source.h"
#include "skydrop/terrain/woods.h"

namespace skydrop::game {
namespace {

std::shared_ptr<const terrain::HeightSource> land() {
  static const auto source = terrain::makeNoiseHeightSource({}, 1);
  return source;
}

// A tall tree with lower land before it to the west: the way there is free.
const terrain::StandingTree& tree() {
  static const terrain::StandingTree found = [] {
    const terrain::Woods woods(land(), 1, false);
    for (int i = 0; i < 400; ++i) {
      const glm::dvec2 at(2000.0 * (i % 20) - 20000, 2000.0 * (i / 20) - 20000);
      for (const terrain::StandingTree& t : woods.around(at, 80)) {
        const double flown = t.foot.y + 0.8 * t.shape.heightM;
        if (t.shape.heightM < 18) continue;
        bool free = true;
        for (double before = -60; before < 130 && free; before += 1) {
          const glm::dvec3 place(t.foot.x - before, flown, t.foot.z);
          free = land()->height({place.x, place.z}) < flown - 8 &&
                 (before < 12 || !woods.touching(std::array{place}, 6.5).has_value());
        }
        if (free) return t;
      }
    }
    return terrain::StandingTree{};
  }();
  return found;
}

WorldSetup towardsTheTree(std::shared_ptr<const terrain::Woods> woods, double above) {
  WorldSetup setup;
  setup.ground = land();
  setup.hasTargets = false;
  setup.woods = std::move(woods);
  const terrain::StandingTree& t = tree();
  setup.start.position = {t.foot.x - 100, t.foot.y + 0.8 * t.shape.heightM + above, t.foot.z};
  setup.start.aboveGround = false;
  setup.start.headingDeg = 90;
  return setup;
}

std::shared_ptr<const terrain::Woods> woodsOf(double density) {
  return std::make_shared<const terrain::Woods>(land(), density, false);
}

// Two seconds, or up to the end of the flight.
World flown(const WorldSetup& setup) {
  World world(setup);
  for (int i = 0; i < 240 && !world.now().aircraft.crashed; ++i) world.step({});
  return world;
}

TEST(TreeCrash, breaksTheFlightWithItsReason) {
  // Level flight into a crown ends there, with trees as the reason; without woods the same flight goes on.
  ASSERT_GT(tree().shape.heightM, 18);
  const World crashed = flown(towardsTheTree(woodsOf(1), 0));
  ASSERT_TRUE(crashed.now().aircraft.crashed);
  EXPECT_EQ(crashed.now().aircraft.gear.endReason, "Flew into a tree");
  const glm::dvec3 at = crashed.now().aircraft.position;
  EXPECT_LT(std::hypot(at.x - tree().foot.x, at.z - tree().foot.z), 12);
  EXPECT_FALSE(flown(towardsTheTree(nullptr, 0)).now().aircraft.crashed);
  EXPECT_FALSE(flown(towardsTheTree(woodsOf(0), 0)).now().aircraft.crashed);
}

TEST(TreeCrash, endsWithRespawnOverTheTops) {
  // The flight goes on where it was last safe.
  WorldSetup setup = towardsTheTree(woodsOf(1), 0);
  World world(setup);
  std::vector<GameEventKind> kinds;
  for (int i = 0; i < 1200; ++i) {
    world.step({});
    for (const GameEvent& event : world.takeEvents()) kinds.push_back(event.kind);
  }
  EXPECT_TRUE(std::ranges::count(kinds, GameEventKind::crashed) >= 1);
  EXPECT_TRUE(std::ranges::count(kinds, GameEventKind::respawned) >= 1);
}

TEST(TreeCrash, isPartOfTheStateAndTheSameEachTime) {
  // The same flight has the same bits; trees belong to what decides the future, and a flight without keeps
  // its digest.
  const WorldSetup with = towardsTheTree(woodsOf(1), 0), without = towardsTheTree(nullptr, 0);
  EXPECT_EQ(flown(with).stateHash(), flown(with).stateHash());
  EXPECT_NE(World(with).stateHash(), World(without).stateHash());
  World switched(with);
  switched.setWoods(nullptr);
  EXPECT_EQ(switched.stateHash(), World(without).stateHash());
}

TEST(TreeCrash, leavesTheAutopilotAlone) {
  // Low over woods for two minutes: it keeps over their tops.
  WorldSetup setup;
  setup.ground = land();
  setup.woods = woodsOf(1);
  setup.start.position = {tree().foot.x, 120, tree().foot.z};
  World world(setup);
  Autopilot pilot(setup.ground, {.clearance = 30});
  pilot.setObstacleHeight(terrain::kTallestTreeM);
  for (int i = 0; i < 120 * 120; ++i) {
    world.step(pilot.decide(world.now()));
    ASSERT_FALSE(world.now().aircraft.crashed) << i / 120.0 << " s: " << world.now().aircraft.gear.endReason;
  }
}

}  // namespace
}  // namespace skydrop::game
