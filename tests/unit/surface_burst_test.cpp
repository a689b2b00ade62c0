// What the world tells of dust and spray: where and when something touched, of what ground, bounded, and
// without any say in the flight.
#include "skydrop/game/surface_burst.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "game/surface_bursts.h"
#include "skydrop/flight/landing_gear.h"
#include "skydrop/game/world.h"
#include "skydrop/terrain/analytic_height_sources.h"
#include "skydrop/terrain/noise_height_source.h"
#include "support/margin.h"

namespace skydrop::game {
namespace {

WorldSetup flatSetup(double height, bool keepsBursts = true) {
  WorldSetup setup;
  setup.ground = terrain::makeFlatSource(height);
  setup.keepsBursts = keepsBursts;
  return setup;
}

// A package that leaves 60 m above the surface, until it has lain for a second.
World dropped(const WorldSetup& setup) {
  World world(setup);
  StartPose pose;
  pose.position = {0, 60, 0};
  world.placeAircraft(pose);
  for (int i = 0; i < 120 * 30; ++i) {
    world.step({.drop = i == 3});
    const auto& packages = world.now().packages;
    if (!packages.empty() && packages.front().landed) break;
  }
  return world;
}

long countOf(const World& world, BurstKind kind) {
  return std::ranges::count(world.now().bursts, kind, &SurfaceBurst::kind);
}

TEST(SurfaceBursts, aPackageThrowsUpWhatItLandsOn) {
  // One burst at the place and the step of the landing, with the speed of the fall, on land and on water.
  for (const double height : {100.0, -5.0}) {
    const World world = dropped(flatSetup(height));
    ASSERT_EQ(world.now().bursts.size(), 1u) << height;
    const SurfaceBurst& burst = world.now().bursts.front();
    EXPECT_EQ(burst.kind, BurstKind::package);
    EXPECT_EQ(burst.onWater, height < 0);
    EXPECT_EQ(burst.position.y, std::max(height, 0.0));
    EXPECT_EQ(burst.position, world.now().packages.front().position);
    EXPECT_EQ(burst.seconds, world.now().simulatedSeconds);
    EXPECT_NEAR(burst.velocity.y, -8, 0.5) << "of a package under its parachute";
  }
}

TEST(SurfaceBursts, decideNothingOfAFlight) {
  // A world that keeps bursts has the states of one that does not, and one that does not tells of none.
  const World with = dropped(flatSetup(100)), without = dropped(flatSetup(100, false));
  EXPECT_EQ(with.stateHash(), without.stateHash());
  EXPECT_FALSE(with.now().bursts.empty());
  EXPECT_TRUE(without.now().bursts.empty());
}

TEST(SurfaceBursts, comeAndGoWithTheSwitch) {
  // Switched off they are gone at once; switched on again there are none of before.
  World world = dropped(flatSetup(100));
  world.setBursts(false, false);
  world.step({});
  EXPECT_TRUE(world.now().bursts.empty());
  world.setBursts(true, false);
  world.step({});
  EXPECT_TRUE(world.now().bursts.empty());
}

TEST(SurfaceBursts, aCrashIsToldOnceWithItsSpeed) {
  // Without a gear: one burst where the aircraft lies, with the velocity that it came with.
  World world(flatSetup(100));
  StartPose pose;
  pose.position = {0, 40, 0};
  pose.pitchDeg = -30;
  world.placeAircraft(pose);
  for (int i = 0; i < 600 && !world.now().aircraft.crashed; ++i) world.step({.pitch = -1});
  ASSERT_TRUE(world.now().aircraft.crashed);
  for (int i = 0; i < 60; ++i) world.step({});
  ASSERT_EQ(world.now().bursts.size(), 1u);
  EXPECT_EQ(world.now().bursts.front().kind, BurstKind::crash);
  EXPECT_GT(glm::length(world.now().bursts.front().velocity), 50);
}

TEST(SurfaceBursts, wheelsAndHullLeaveThemOnTheirWay) {
  // A landing on wheels: the touch-down and then one for each wheel every three metres, none at rest. Over
  // water: the ditching and the hull's way.
  for (const double height : {100.0, -5.0}) {
    WorldSetup setup = flatSetup(height);
    setup.gear = flight::GearSettings();
    setup.start.position = {0, 2.2, 0};
    setup.start.speed = 32;
    World world(setup);
    double wayM = 0;
    std::size_t most = 0;
    for (int i = 0; i < 120 * 5; ++i) {
      const glm::dvec3 from = world.now().aircraft.position;
      world.step({.brake = 1, .pitch = 0.3});
      if (!world.now().bursts.empty()) wayM += glm::distance(from, world.now().aircraft.position);
      most = std::max(most, world.now().bursts.size());
    }
    const bool wet = height < 0;
    EXPECT_GT(countOf(world, wet ? BurstKind::ditching : BurstKind::touchDown), 0) << height;
    const long onTheWay = countOf(world, wet ? BurstKind::swimming : BurstKind::rolling);
    EXPECT_GT(onTheWay, 3) << height;
    EXPECT_LT(static_cast<double>(onTheWay), 2 * wayM / 1.6 + 4) << height;
    EXPECT_LE(most, kMostBursts);
    for (const SurfaceBurst& burst : world.now().bursts) EXPECT_EQ(burst.onWater, wet);
  }
}

TEST(SurfaceBursts, U01_areBoundedHoweverManyHappen) {
  // A thousand landings in one step and a way of an hour: at most kMostBursts, the newest, none older than
  // kBurstSeconds.
  test::noFaults("U01", "counts of bursts");
  const WorldSetup setup = flatSetup(20);
  const FlownAir air(setup);
  SurfaceBursts bursts(setup, air);
  std::vector<GameEvent> events(1000, {GameEventKind::packageLanded, 1, {5, 20, 5}});
  bursts.step(1, events, {}, nullptr);
  EXPECT_EQ(bursts.all().size(), kMostBursts);
  EXPECT_EQ(bursts.all().back().number, 1000u);
  bursts.step(1 + kBurstSeconds, {}, {}, nullptr);
  EXPECT_EQ(bursts.all().size(), kMostBursts);
  bursts.step(1.01 + kBurstSeconds, {}, {}, nullptr);
  EXPECT_TRUE(bursts.all().empty());
}

TEST(LooseGround, followsWhatTheLandIsMadeOf) {
  // Sand is looser than meadow and snow the brightest; each within [0, 1]; none where there is no place.
  const auto of = [](double height) {
    return looseGroundAt(*terrain::makeFlatSource(height), {40, height, 70}, false);
  };
  EXPECT_GT(of(1.2).looseness, 2 * of(150).looseness) << "sand, meadow";
  EXPECT_GT(of(1.2).albedo.x, of(150).albedo.x);
  EXPECT_GT(of(1600).albedo.y, 0.7) << "snow";
  EXPECT_GT(of(1600).albedo.y, of(1.2).albedo.y);
  const auto steep = terrain::makeTiltedPlaneSource(500, {1.6, 0});
  EXPECT_LT(looseGroundAt(*steep, {0, 500, 0}, false).looseness, of(150).looseness) << "rock";
  const auto land = terrain::makeNoiseHeightSource({}, 1);
  for (int i = 0; i < 400; ++i) {
    const LooseGround ground = looseGroundAt(*land, {i * 137.0 - 20000, 0, i * 61.0 + 500}, i % 2 == 0);
    EXPECT_GE(ground.looseness, 0);
    EXPECT_LE(ground.looseness, 1);
    for (int c = 0; c < 3; ++c) EXPECT_TRUE(ground.albedo[c] > 0 && ground.albedo[c] < 1) << i;
  }
  EXPECT_EQ(looseGroundAt(*land, {1e13, 0, 0}, false).looseness, 0);
  EXPECT_EQ(looseGroundAt(*land, {std::nan(""), 0, 0}, false).looseness, 0);
}

}  // namespace
}  // namespace skydrop::game
