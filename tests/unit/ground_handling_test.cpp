// Touch-downs, damage, ditching and take-off in the world, and what of the old rules stays.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <memory>
#include <string>
#include <vector>

#include "skydrop/game/world.h"
#include "skydrop/terrain/analytic_height_sources.h"

namespace skydrop::game {
namespace {

struct Arrival {
  double height = 2.4, speed = 35, pitchDeg = -1, bankDeg = 0;
};

WorldSetup setupOver(std::shared_ptr<const terrain::HeightSource> ground, const Arrival& arrival,
                     bool hasGear = true) {
  WorldSetup setup;
  setup.ground = std::move(ground);
  setup.hasTargets = false;
  if (hasGear) setup.gear = flight::GearSettings{};
  setup.start = {.position = {0, arrival.height, 0},
                 .pitchDeg = arrival.pitchDeg,
                 .bankDeg = arrival.bankDeg,
                 .speed = arrival.speed};
  // Placed low and not raised: the start is over the ground that a gear needs.
  setup.game.contactHeight = 0.5;
  return setup;
}

struct Flown {
  std::vector<GameEventKind> kinds;
  std::string reason;
  Snapshot end;
  bool has(GameEventKind kind) const { return std::find(kinds.begin(), kinds.end(), kind) != kinds.end(); }
};

Flown fly(World& world, double seconds, const std::function<Controls(const Snapshot&)>& pilot) {
  Flown out;
  for (int i = 0; i < static_cast<int>(seconds * 120); ++i) {
    world.step(pilot(world.now()));
    for (const GameEvent& event : world.takeEvents()) {
      out.kinds.push_back(event.kind);
      if (event.kind == GameEventKind::crashed) out.reason = world.now().aircraft.gear.endReason;
    }
  }
  out.end = world.now();
  return out;
}
Flown fly(const WorldSetup& setup, double seconds, const Controls& controls) {
  World world(setup);
  return fly(world, seconds, [&](const Snapshot&) { return controls; });
}

TEST(GroundHandling, aSoftLandingRollsToAHalt) {
  // 35 m/s, .6 m/s of sink: touches down, brakes, stands; nothing breaks, no space drops a package there.
  const Flown flown = fly(setupOver(terrain::makeFlatSource(50), {}), 30, {.brake = 1, .drop = true});
  EXPECT_TRUE(flown.has(GameEventKind::touchedDown));
  EXPECT_FALSE(flown.has(GameEventKind::crashed));
  EXPECT_FALSE(flown.has(GameEventKind::respawned));
  EXPECT_EQ(flown.end.aircraft.gear.wheelsDown, 3);
  EXPECT_LT(flown.end.aircraft.gear.groundSpeedMps, 0.05);
  EXPECT_FALSE(flown.end.aircraft.stallWarning) << "an aircraft that stands does not stall";
}

TEST(GroundHandling, withoutAGearEveryTouchIsACrash) {
  const Flown flown = fly(setupOver(terrain::makeFlatSource(50), {}, false), 5, {.brake = 1});
  EXPECT_TRUE(flown.has(GameEventKind::crashed));
  EXPECT_FALSE(flown.has(GameEventKind::touchedDown));
  EXPECT_FALSE(flown.end.aircraft.gear.present);
}

TEST(GroundHandling, tooHardATouchBreaksTheGearAndSaysWhy) {
  const Flown flown =
      fly(setupOver(terrain::makeFlatSource(50), {.height = 2.6, .pitchDeg = -9}), 1.5, {.brake = 1});
  EXPECT_TRUE(flown.has(GameEventKind::crashed));
  EXPECT_NE(flown.reason.find("met the ground at"), std::string::npos) << flown.reason;
  EXPECT_NE(flown.reason.find("limit 4.0"), std::string::npos) << flown.reason;
}

TEST(GroundHandling, aWingTipOnTheGroundBreaksAtSpeed) {
  const Flown flown = fly(setupOver(terrain::makeFlatSource(50), {.height = 3.5, .speed = 40, .bankDeg = 55}),
                          2, {.roll = 1});
  EXPECT_TRUE(flown.has(GameEventKind::crashed));
  EXPECT_NE(flown.reason.find("wing struck the ground"), std::string::npos) << flown.reason;
}

TEST(GroundHandling, tooMuchAcrossTheWheelsBreaksThem) {
  // Level and 40 degrees askew at 34 m/s, on tyres that do not slide: past a load of .6 weights it breaks,
  // past 20 it does not.
  for (const double most : {0.6, 20.0}) {
    WorldSetup setup = setupOver(terrain::makeFlatSource(50), {.height = 1.9, .speed = 34, .pitchDeg = 0});
    setup.gear->mostSideLoad = most;
    setup.gear->mostStrikeSpeed = 60;
    setup.gear->friction = 1.5;
    World world(setup);
    Flown flown;
    bool turned = false;
    for (int i = 0; i < 360 && !flown.has(GameEventKind::crashed); ++i) {
      world.step({.brake = 1, .yaw = 1});
      for (const GameEvent& event : world.takeEvents()) {
        flown.kinds.push_back(event.kind);
        if (event.kind == GameEventKind::crashed) flown.reason = world.now().aircraft.gear.endReason;
      }
      turned = turned || world.now().aircraft.gear.wheelsDown > 0;
    }
    EXPECT_TRUE(turned);
    EXPECT_EQ(flown.reason.find("weights across the wheels") != std::string::npos, most < 1) << flown.reason;
  }
}

TEST(GroundHandling, steepGroundBreaksIt) {
  // Up a slope of 25 degrees, met at 20 m/s.
  WorldSetup setup =
      setupOver(terrain::makeTiltedPlaneSource(50, {0, -0.466}), {.height = 3, .speed = 20, .pitchDeg = 20});
  setup.gear->mostSinkRate = 20;
  const Flown flown = fly(setup, 1, {.brake = 1});
  EXPECT_TRUE(flown.has(GameEventKind::crashed));
  EXPECT_NE(flown.reason.find("too steep a ground, 25 degrees"), std::string::npos) << flown.reason;
}

TEST(GroundHandling, aGentleDitchingFloatsAndEndsTheFlight) {
  // At 33 m/s and 1 m/s of sink it swims for floatSeconds, its middle within a metre of the water, and then
  // the flight goes on elsewhere; no crash.
  World world(setupOver(terrain::makeFlatSource(-30), {.height = 3, .speed = 33, .pitchDeg = -1}));
  Flown flown = fly(world, 5, [](const Snapshot&) { return Controls{.brake = 1}; });
  EXPECT_TRUE(flown.has(GameEventKind::ditched));
  EXPECT_FALSE(flown.has(GameEventKind::crashed)) << flown.reason;
  EXPECT_TRUE(flown.end.aircraft.gear.swims);
  EXPECT_NEAR(flown.end.aircraft.position.y, 0, 1);
  EXPECT_LT(glm::length(flown.end.aircraft.velocity), 4);
  flown = fly(world, 6, [](const Snapshot&) { return Controls{}; });
  EXPECT_TRUE(flown.has(GameEventKind::respawned));
  EXPECT_FALSE(flown.end.aircraft.gear.swims);
}

TEST(GroundHandling, hardOnTheWaterItBreaksUp) {
  const Flown flown = fly(
      setupOver(terrain::makeFlatSource(-30), {.height = 4, .speed = 45, .pitchDeg = -12}), 2, {.brake = 1});
  EXPECT_TRUE(flown.has(GameEventKind::crashed));
  EXPECT_NE(flown.reason.find("Broke up on the water"), std::string::npos) << flown.reason;
}

TEST(GroundHandling, fromTheWheelsItTakesOffWithWAndComesBackToThemWithR) {
  WorldSetup setup = setupOver(terrain::makeFlatSource(50), {});
  setup.start.onWheels = true;
  World world(setup);
  EXPECT_NEAR(world.now().aircraft.heightAboveGround, 1.29, 0.01);
  Flown flown = fly(world, 5, [](const Snapshot&) { return Controls{}; });
  EXPECT_LT(glm::length(world.now().aircraft.position - glm::dvec3(0, 51.29, 0)), 0.05)
      << "hands off it stands";
  flown = fly(world, 15, [](const Snapshot& now) {
    return Controls{.thrust = 1, .pitch = now.aircraft.airspeedMps > 40 ? 0.3 : 0};
  });
  EXPECT_TRUE(flown.has(GameEventKind::tookOff));
  EXPECT_GT(flown.end.aircraft.heightAboveGround, 20);
  fly(world, 0.1, [](const Snapshot&) { return Controls{.reset = true}; });
  EXPECT_EQ(world.now().aircraft.gear.wheelsDown, 3);
  EXPECT_LT(world.now().aircraft.gear.groundSpeedMps, 0.2);
}

TEST(GroundHandling, theSameControlsGiveTheSameBits) {
  // A landing, braking, a turn and a take-off, twice; and the digest sees the brakes.
  const auto hash = [](double brake) {
    World world(setupOver(terrain::makeTiltedPlaneSource(50, {0.01, 0.005}), {}));
    fly(world, 20, [&](const Snapshot& now) {
      const double t = now.simulatedSeconds;
      return Controls{.thrust = t > 14 ? 1.0 : 0, .brake = t < 10 ? brake : 0, .yaw = t > 10 ? 0.5 : 0};
    });
    return world.stateHash();
  };
  EXPECT_EQ(hash(1), hash(1));
  EXPECT_NE(hash(1), hash(0.9));
}

TEST(GroundHandling, highUpTheGearChangesNoBitOfTheFlight) {
  const auto place = [](bool hasGear) {
    World world(setupOver(terrain::makeFlatSource(50), {.height = 500, .speed = 70}, hasGear));
    fly(world, 20, [](const Snapshot& now) {
      return Controls{.pitch = std::sin(now.simulatedSeconds), .roll = std::cos(now.simulatedSeconds)};
    });
    return world.now().aircraft.position;
  };
  EXPECT_EQ(place(true), place(false));
}

TEST(GroundHandling, aGearThatComesAndGoesLeavesAFlyingAircraft) {
  World world(setupOver(terrain::makeFlatSource(50), {}));
  fly(world, 20, [](const Snapshot&) { return Controls{.brake = 1}; });
  ASSERT_EQ(world.now().aircraft.gear.wheelsDown, 3);
  world.setGear(std::nullopt);
  Flown flown = fly(world, 3, [](const Snapshot&) { return Controls{}; });
  EXPECT_FALSE(flown.has(GameEventKind::crashed));
  EXPECT_GT(flown.end.aircraft.heightAboveGround, 30);
  world.setGear(flight::GearSettings{});
  flown = fly(world, 3, [](const Snapshot&) { return Controls{}; });
  EXPECT_TRUE(flown.end.aircraft.gear.present);
}

}  // namespace
}  // namespace skydrop::game
