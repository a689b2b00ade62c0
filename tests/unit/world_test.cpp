#include "skydrop/game/world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <set>

#include "skydrop/core/error.h"
#include "skydrop/core/guards.h"
#include "skydrop/terrain/analytic_height_sources.h"
#include "skydrop/terrain/noise_height_source.h"

namespace skydrop::game {
namespace {

WorldSetup flatSetup(double height = 10) {
  WorldSetup setup;
  setup.ground = terrain::makeFlatSource(height);
  return setup;
}

// Steps until an event of this kind, at most `seconds`; the event, or one of kind `reset` at step 0.
GameEvent stepUntil(World& world, GameEventKind kind, double seconds, const Controls& controls = {}) {
  for (int i = 0; i < static_cast<int>(seconds * 120); ++i) {
    world.step(controls);
    for (const GameEvent& event : world.takeEvents()) {
      if (event.kind == kind) return event;
    }
  }
  ADD_FAILURE() << "no such event";
  return {GameEventKind::reset, 0, {}, 0, 0, false};
}

// 300 m above the ground, flying north, so far south of the target that a package dropped now lands `off`
// metres south of it.
void placeForDrop(World& world, double off) {
  StartPose pose;
  pose.position = world.now().target.position;
  pose.position.y = 310;
  pose.aboveGround = false;
  world.placeAircraft(pose);
  pose.position.z += world.now().target.position.z - world.now().predictedLanding->z + off;
  world.placeAircraft(pose);
}

TEST(World, startsInLevelCruiseWhereItWasTold) {
  // The pose of the setup: 500 m above the surface below, heading east, 70 m/s along the nose.
  WorldSetup setup = flatSetup(200);
  setup.start.headingDeg = 90;
  const World world(setup);
  const AircraftSnapshot& craft = world.now().aircraft;
  EXPECT_TRUE(craft.present);
  EXPECT_EQ(craft.position.y, 700);
  EXPECT_NEAR(craft.heightAboveGround, 500, 1e-9);
  EXPECT_NEAR(craft.velocity.x, 70, 1e-12);
  EXPECT_NEAR(craft.headingRad, std::acos(0.0), 1e-12);
  EXPECT_EQ(world.now().stepCount, 0u);
}

TEST(World, aSceneWithoutAircraftOrTargetsHasOnlyAClock) {
  // Optional parts that are left out leave no trace: no aircraft, no target, no predicted landing, drops do
  // nothing.
  WorldSetup setup = flatSetup();
  setup.hasAircraft = setup.hasTargets = false;
  World world(setup);
  for (int i = 0; i < 240; ++i) world.step({.thrust = 1, .drop = i % 2 == 0, .reset = i % 3 == 0});
  world.placeAircraft({});
  EXPECT_EQ(world.stepCount(), 240u);
  EXPECT_EQ(world.now().simulatedSeconds, 2);
  EXPECT_FALSE(world.now().aircraft.present);
  EXPECT_FALSE(world.now().target.present);
  EXPECT_FALSE(world.now().predictedLanding);
  EXPECT_TRUE(world.now().packages.empty());
  EXPECT_TRUE(world.takeEvents().empty());
}

TEST(World, withoutTargetsPackagesLandAndNothingScores) {
  // The package still falls, lands and is removed; no score, no miss.
  WorldSetup setup = flatSetup();
  setup.hasTargets = false;
  World world(setup);
  world.step({.drop = true});
  stepUntil(world, GameEventKind::packageLanded, 120);
  stepUntil(world, GameEventKind::packageRemoved, 20);
  EXPECT_EQ(world.now().drops, 1);
  EXPECT_EQ(world.now().score, 0);
  EXPECT_EQ(world.now().misses, 0);
}

TEST(World, unusableSetupsAreRefused) {
  // No ground, NaN in the pose or the wind, settings out of any sense: RangeError, before anything runs.
  EXPECT_THROW(World(WorldSetup{}), core::RangeError);
  const double kNaN = std::numeric_limits<double>::quiet_NaN();
  WorldSetup pose = flatSetup(), wind = flatSetup(), game = flatSetup(), mass = flatSetup(),
             chute = flatSetup();
  pose.start.position.x = kNaN;
  wind.wind.y = kNaN;
  game.game.targetRadius = -1;
  mass.airplane.mass = 0;
  chute.package.parachuteSpeed = 0;
  for (const WorldSetup& setup : {pose, wind, game, mass, chute})
    EXPECT_THROW(World{setup}, core::RangeError);
}

TEST(World, aDropAtTheTargetDrawsTheNextTargetAtOnceAndScoresOnLanding) {
  // The drop text shows, space drops: the next target is there in the same step; the score comes with the
  // landing, by the target that was current at the release.
  World world(flatSetup());
  placeForDrop(world, 30);
  EXPECT_TRUE(world.now().dropZone);
  const std::uint32_t aimed = world.now().target.id;
  world.step({.drop = true});
  EXPECT_EQ(world.now().target.id, aimed + 1);
  EXPECT_EQ(world.now().score, 0);
  const GameEvent landing = stepUntil(world, GameEventKind::scored, 120);
  EXPECT_NEAR(landing.missDistance, 30, 1);  // m: the drop comes one step, .6 m, after the prediction
  EXPECT_EQ(world.now().score, 1);
  EXPECT_EQ(world.now().misses, 0);
  EXPECT_EQ(world.now().target.id, aimed + 1);
  ASSERT_FALSE(world.now().messages.empty());
  EXPECT_NE(world.now().messages.back().text.find("On target"), std::string::npos);
}

TEST(World, aDropElsewhereIsAMissAndKeepsTheTarget) {
  // No drop text, space drops anyway: the target stays, and the landing says how far it missed.
  World world(flatSetup());
  placeForDrop(world, 400);
  EXPECT_FALSE(world.now().dropZone);
  const std::uint32_t current = world.now().target.id;
  world.step({.drop = true});
  EXPECT_EQ(world.now().target.id, current);
  const GameEvent landing = stepUntil(world, GameEventKind::missed, 120);
  EXPECT_NEAR(landing.missDistance, 400, 1);
  EXPECT_EQ(world.now().misses, 1);
  EXPECT_EQ(world.now().score, 0);
  EXPECT_EQ(world.now().target.id, current);
  ASSERT_FALSE(world.now().messages.empty());
  EXPECT_NE(world.now().messages.back().text.find("Missed by 299"), std::string::npos);  // outside the circle
}

TEST(World, twoDropsAtOneTargetBelongToTwoTargets) {
  // The second press comes when the next target is current already: it is a drop elsewhere, and misses.
  World world(flatSetup());
  placeForDrop(world, 0);
  world.step({.drop = true});
  const std::uint32_t next = world.now().target.id;
  for (int i = 0; i < 250; ++i) world.step({});
  world.step({.drop = true});
  EXPECT_EQ(world.now().drops, 2);
  EXPECT_EQ(world.now().target.id, next);
  stepUntil(world, GameEventKind::scored, 120);
  stepUntil(world, GameEventKind::missed, 120);
  EXPECT_EQ(world.now().score, 1);
  EXPECT_EQ(world.now().misses, 1);
}

// Flat land with one spire, 320 m high and 80 m wide at its foot: narrow enough for the prediction to step
// over.
class SpireLand final : public terrain::HeightSource {
 public:
  explicit SpireLand(const glm::dvec2& at) : at_(at) {}
  terrain::HeightSample sample(glm::dvec2 xz) const override {
    return {std::max(10.0, 320 - 7.8 * glm::length(xz - at_)), {0, 0}};
  }
  terrain::HeightBounds bounds(glm::dvec2, glm::dvec2) const override { return range(); }
  terrain::HeightBounds range() const override { return {10, 320}; }

 private:
  glm::dvec2 at_;
};

TEST(World, aDropElsewhereThatComesDownInsideScoresAndFinishesTheTarget) {
  // Predicted 120 m from the centre the drop keeps the target; a spire that the prediction did not see stops
  // the package 62 m from it: that scores, and the next target is drawn, so that this one cannot score again.
  const glm::dvec3 target = World(flatSetup()).now().target.position;
  WorldSetup setup = flatSetup();
  setup.ground = std::make_shared<const SpireLand>(glm::dvec2(target.x + 60, target.z - 18));
  World world(setup);
  ASSERT_EQ(world.now().target.position, target);
  StartPose pose;
  pose.position = {target.x + 60, 310, target.z + 12};
  pose.aboveGround = false;
  world.placeAircraft(pose);
  world.step({.drop = true});
  EXPECT_EQ(world.now().target.id, 1u);
  const GameEvent landing = stepUntil(world, GameEventKind::scored, 60);
  EXPECT_NEAR(landing.missDistance, 62, 5);
  EXPECT_EQ(world.now().target.id, 2u);
}

TEST(World, theCoolDownSwallowsPressesAndAHeldKeyDropsOnce) {
  // Space held for 10 s drops one package; pressed again within 2 s of a drop it does nothing, after that it
  // drops.
  World world(flatSetup());
  for (int i = 0; i < 1200; ++i) world.step({.drop = true});
  EXPECT_EQ(world.now().drops, 1);
  world.step({});
  world.step({.drop = true});
  EXPECT_EQ(world.now().drops, 2);
  EXPECT_NEAR(world.now().cooldownSeconds, 2, 0.01);
  for (int i = 0; i < 100; ++i) world.step({.drop = i % 2 == 1});
  EXPECT_EQ(world.now().drops, 2);
  for (int i = 0; i < 150; ++i) world.step({});
  world.step({.drop = true});
  EXPECT_EQ(world.now().drops, 3);
}

TEST(World, aPackageOpensItsParachuteLandsAndIsRemovedLater) {
  // The life of a package in events: dropped, opened a second later, landed, gone 8 s after that.
  World world(flatSetup());
  world.step({.drop = true});
  const GameEvent dropped = world.takeEvents().back();
  EXPECT_EQ(dropped.kind, GameEventKind::drop);
  const GameEvent opened = stepUntil(world, GameEventKind::parachuteOpened, 5);
  EXPECT_NEAR(static_cast<double>(opened.step - dropped.step) / 120, 1, 0.02);
  const GameEvent landed = stepUntil(world, GameEventKind::packageLanded, 120);
  EXPECT_NEAR(landed.position.y, 10, 1e-6);
  ASSERT_EQ(world.now().packages.size(), 1u);
  EXPECT_TRUE(world.now().packages[0].landed);
  EXPECT_EQ(world.now().packages[0].parachuteOpen, 1);
  const GameEvent removed = stepUntil(world, GameEventKind::packageRemoved, 20);
  EXPECT_NEAR(static_cast<double>(removed.step - landed.step) / 120, 8, 0.02);
  EXPECT_TRUE(world.now().packages.empty());
}

TEST(World, aCrashSaysSoAndTheAircraftComesBackWhereItWasSafe) {
  // Dived into the ground: message, event, 2.5 s on the ground, then in level cruise at a place that it had
  // flown through at least 4 s before, higher than 60 m, on its old heading.
  WorldSetup setup = flatSetup(50);
  setup.start.headingDeg = 30;
  World world(setup);
  for (int i = 0; i < 1200; ++i) world.step({});
  const GameEvent crash = stepUntil(world, GameEventKind::crashed, 60, {.pitch = -1});
  EXPECT_FALSE(crash.onWater);
  EXPECT_TRUE(world.now().aircraft.crashed);
  EXPECT_EQ(world.now().messages.back().text, "Crashed into the ground");
  EXPECT_NEAR(world.now().aircraft.heightAboveGround, setup.game.contactHeight, 0.01);
  EXPECT_EQ(world.now().aircraft.velocity, glm::dvec3(0));
  EXPECT_FALSE(world.now().predictedLanding);
  const GameEvent back = stepUntil(world, GameEventKind::respawned, 10, {.pitch = -1, .drop = true});
  EXPECT_NEAR(static_cast<double>(back.step - crash.step) / 120, 2.5, 0.02);
  const AircraftSnapshot& craft = world.now().aircraft;
  EXPECT_FALSE(craft.crashed);
  EXPECT_GT(craft.heightAboveGround, 60);
  EXPECT_NEAR(glm::length(craft.velocity), 70, 1e-9);
  EXPECT_NEAR(craft.headingRad * 57.29578, 30, 1);
  EXPECT_NEAR(craft.bankRad, 0, 1e-12);
  EXPECT_GT(glm::length(craft.position - crash.position), 3.5 * 70);
  EXPECT_EQ(world.now().drops, 0);  // nothing drops from a wreck
}

TEST(World, ditchingInTheSeaIsACrashOnWater) {
  // The sea floor lies 40 m down; the aircraft stops on the water at 0.
  World world(flatSetup(-40));
  const GameEvent crash = stepUntil(world, GameEventKind::crashed, 120, {.pitch = -1});
  EXPECT_TRUE(crash.onWater);
  EXPECT_NEAR(crash.position.y, 1.5, 0.01);
  EXPECT_EQ(world.now().messages.back().text, "Ditched in the sea");
}

TEST(World, respawnsDoNotRepeatTheSameCrashForEver) {
  // Hands off towards a wall 800 m high: each respawn clears the ground ahead, so the second flight passes
  // over it.
  WorldSetup setup = flatSetup();
  setup.ground = terrain::makeStepSource(1500, 10, 800);
  setup.hasTargets = false;
  setup.start.headingDeg = 90;
  setup.start.position = {0, 200, 0};
  World world(setup);
  int crashes = 0;
  for (int i = 0; i < 120 * 90; ++i) {
    world.step({});
    for (const GameEvent& event : world.takeEvents()) crashes += event.kind == GameEventKind::crashed;
  }
  EXPECT_EQ(crashes, 1);
  EXPECT_GT(world.now().aircraft.position.x, 2000);
}

TEST(World, resetPutsTheAircraftBackAndKeepsTheScore) {
  // R: start pose, level, nothing else changes; held it happens once.
  World world(flatSetup());
  placeForDrop(world, 0);
  world.step({.drop = true});
  stepUntil(world, GameEventKind::scored, 120, {.thrust = 1});
  for (int i = 0; i < 60; ++i) world.step({.thrust = 1, .reset = true});
  EXPECT_EQ(world.now().score, 1);
  EXPECT_NEAR(world.now().aircraft.position.z, -70 * 59 / 120.0, 2);
  EXPECT_EQ(world.now().aircraft.spawnCount, 4u);  // start, placed twice, reset
}

TEST(World, aStallIsToldInOrderWarningBuffetStallAndAllClear) {
  // S and the stick half back from cruise: the warning comes seconds before the stall, the shaking grows from
  // none over a little to strong, and with everything let go all three are over within 10 s.
  WorldSetup setup = flatSetup();
  setup.hasTargets = false;
  World world(setup);
  double warnedAt = 0, stalledAt = 0, shakenBefore = 0;
  while (stalledAt == 0 && world.now().simulatedSeconds < 60) {
    const AircraftSnapshot& craft = world.now().aircraft;
    if (craft.stallWarning && warnedAt == 0) warnedAt = world.now().simulatedSeconds;
    EXPECT_TRUE(craft.stallWarning || craft.buffet == 0);
    if (craft.stalled) stalledAt = world.now().simulatedSeconds;
    if (!craft.stalled) shakenBefore = std::max(shakenBefore, craft.buffet);
    world.step({.brake = 1, .pitch = world.now().simulatedSeconds > 18 ? 0.5 : 0.0});
  }
  ASSERT_GT(stalledAt, 0);
  EXPECT_GT(warnedAt, 0);
  EXPECT_GT(stalledAt - warnedAt, 1);
  EXPECT_GT(shakenBefore, 0.05);
  EXPECT_LT(shakenBefore, 0.5);
  double strongest = 0;
  for (int i = 0; i < 1200; ++i) {
    world.step({});
    strongest = std::max(strongest, world.now().aircraft.buffet);
  }
  EXPECT_GT(strongest, 0.3);
  EXPECT_FALSE(world.now().aircraft.stalled);
  EXPECT_FALSE(world.now().aircraft.stallWarning);
  EXPECT_LT(world.now().aircraft.buffet, 0.01);
}

TEST(World, eventsThatNobodyTakesDoNotPileUp) {
  // 3000 resets without taking an event: the newest 1024 are kept, in order.
  World world(flatSetup());
  for (int i = 0; i < 6000; ++i) world.step({.reset = i % 2 == 0});
  const auto events = world.takeEvents();
  ASSERT_EQ(events.size(), 1024u);
  EXPECT_EQ(events.back().step, 5999u);
  EXPECT_EQ(events.front().step + 2 * 1023, 5999u);
  EXPECT_TRUE(world.takeEvents().empty());
}

TEST(World, placedInsideTheGroundItStartsAboveIt) {
  // A pose from the command line below the surface is lifted, and counted.
  core::resetGuardCounts();
  World world(flatSetup(300));
  StartPose pose;
  pose.position = {0, 100, 0};
  pose.aboveGround = false;
  world.placeAircraft(pose);
  EXPECT_NEAR(world.now().aircraft.heightAboveGround, 60, 1e-9);
  EXPECT_EQ(core::guardCount(core::Guard::respawnRaised), 1u);
}

TEST(World, interpolationIsTheStepsAtItsEndsAndNeverCrossesARespawn) {
  // alpha 0 and 1 are before() and now(); one half is the middle; across a reset it stays at the new place.
  World world(flatSetup());
  for (int i = 0; i < 100; ++i) world.step({.roll = 1, .drop = true});
  EXPECT_EQ(world.interpolated(0).aircraft.position, world.before().aircraft.position);
  EXPECT_EQ(world.interpolated(1).aircraft.position, world.now().aircraft.position);
  EXPECT_EQ(world.interpolated(7).aircraft.position, world.now().aircraft.position);
  EXPECT_EQ(world.interpolated(std::nan("")).aircraft.position, world.now().aircraft.position);
  const glm::dvec3 middle = 0.5 * (world.before().aircraft.position + world.now().aircraft.position);
  EXPECT_LT(glm::length(world.interpolated(0.5).aircraft.position - middle), 1e-9);
  EXPECT_NEAR(glm::length(world.interpolated(0.3).aircraft.orientation), 1, 1e-12);
  ASSERT_EQ(world.now().packages.size(), 1u);
  const glm::dvec3 box = 0.5 * (world.before().packages[0].position + world.now().packages[0].position);
  EXPECT_LT(glm::length(world.interpolated(0.5).packages[0].position - box), 1e-9);
  world.step({.reset = true});
  EXPECT_EQ(world.interpolated(0.2).aircraft.position, world.now().aircraft.position);
}

TEST(World, targetsLieOnFlatDryLandInTheRing) {
  // 40 targets on real land: 2 to 6 km from the aircraft at the draw, above the sea, slope under 20 degrees;
  // no two alike.
  WorldSetup setup;
  setup.ground = terrain::makeNoiseHeightSource({}, 1);
  World world(setup);
  std::set<double> seen;
  for (int i = 0; i < 40; ++i) {
    core::resetGuardCounts();
    const std::uint32_t before = world.now().target.id;
    StartPose pose;
    const auto landing = world.now().target.position;
    pose.position = landing + glm::dvec3(0, 300, 113);
    pose.aboveGround = false;
    world.placeAircraft(pose);
    for (int k = 0; k < 300; ++k) world.step({});
    pose.position.y = landing.y + 300;
    world.placeAircraft(pose);
    world.step({.drop = true});
    const TargetSnapshot& target = world.now().target;
    if (target.id == before) continue;  // a hill in the way: no drop at the target here
    const glm::dvec2 at(target.position.x, target.position.z);
    const terrain::HeightSample ground = setup.ground->sample(at);
    EXPECT_GT(ground.height, 0);
    EXPECT_EQ(ground.height, target.position.y);
    EXPECT_LT(std::atan(glm::length(ground.gradient)) * 57.29578, 20);
    if (core::guardCount(core::Guard::targetWidened) == 0) {
      EXPECT_GT(target.distance, 2000 - 1);  // the aircraft moved half a metre since the draw
      EXPECT_LT(target.distance, 6000 + 1);
    }
    EXPECT_TRUE(seen.insert(target.position.x).second);
  }
  EXPECT_GT(seen.size(), 20u);
}

TEST(World, seedsDrawDifferentTargetsAndTheSameSeedTheSame) {
  // The target is decided by the seed and nothing else.
  WorldSetup one = flatSetup(), two = flatSetup();
  two.seed = 2;
  EXPECT_EQ(World(one).now().target.position, World(one).now().target.position);
  EXPECT_NE(World(one).now().target.position, World(two).now().target.position);
}

TEST(World, anAllSeaWorldHasNoTargetAndSaysSo) {
  // No land anywhere: no target, a message, and the game goes on.
  World world(flatSetup(-100));
  EXPECT_FALSE(world.now().target.present);
  ASSERT_FALSE(world.now().messages.empty());
  EXPECT_EQ(world.now().messages[0].text, "No land for a target in reach");
  world.step({.drop = true});
  stepUntil(world, GameEventKind::packageLanded, 120);
  EXPECT_TRUE(world.now().packages[0].onWater);
  EXPECT_EQ(world.now().misses, 0);
}

TEST(World, messagesGoAwayAfterThreeSeconds) {
  // A message counts down and disappears.
  World world(flatSetup(-100));
  ASSERT_EQ(world.now().messages.size(), 1u);
  EXPECT_NEAR(world.now().messages[0].secondsLeft, 3, 0.01);
  for (int i = 0; i < 361; ++i) world.step({});
  EXPECT_TRUE(world.now().messages.empty());
}

TEST(World, liveSettingsTakeEffectAndUnusableOnesChangeNothing) {
  // More thrust from the menu is felt at once; NaN is refused and the flight goes on as before.
  World changed(flatSetup()), plain(flatSetup());
  flight::AirplaneSettings strong, broken;
  strong.maxThrottle = 400;
  broken.mass = std::nan("");
  changed.apply(strong);
  EXPECT_THROW(changed.apply(broken), core::RangeError);
  GameSettings negative;
  negative.dropCooldown = -1;
  EXPECT_THROW(changed.apply(negative), core::RangeError);
  flight::PackageSettings sinking;
  sinking.parachuteSpeed = 0;
  EXPECT_THROW(changed.apply(sinking), core::RangeError);
  for (int i = 0; i < 600; ++i) {
    changed.step({.thrust = 1});
    plain.step({.thrust = 1});
  }
  EXPECT_GT(changed.now().aircraft.airspeedMps, plain.now().aircraft.airspeedMps + 10);
}

TEST(World, windCarriesAircraftPackagesAndTheirPrediction) {
  // In 10 m/s from the west everything drifts east, and the predicted landing point knows it.
  WorldSetup setup = flatSetup();
  setup.wind = {10, 0, 0};
  World world(setup);
  const glm::dvec3 predicted = *world.now().predictedLanding;
  world.step({.drop = true});
  const GameEvent landed = stepUntil(world, GameEventKind::packageLanded, 200);
  EXPECT_NEAR(world.now().aircraft.airspeedMps, 70, 1e-6);
  EXPECT_LT(glm::length(landed.position - predicted), 2);  // m: dropped one step later, 0.6 m further on
  EXPECT_GT(landed.position.x, 300);
}

}  // namespace
}  // namespace skydrop::game
