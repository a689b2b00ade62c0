// The autopilot on strips: approaches, lands, stops and takes off again.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>

#include "skydrop/game/autopilot.h"
#include "skydrop/game/world.h"
#include "skydrop/terrain/noise_height_source.h"
#include "skydrop/terrain/strips.h"
#include "support/soak.h"

namespace skydrop::game {
namespace {

struct Circuits {
  int landings = 0;  // that ended in a stop
  int takeOffs = 0, crashes = 0, reached = 0;
  double hardest = 0;  // sink rate at a touch-down, m/s
  std::string reason;
};

// Circuits without targets, for so long, from above the strip nearest to the origin, over the land of a seed.
Circuits fliesCircuits(std::uint64_t seed, double seconds, const glm::dvec3& wind) {
  Circuits out;
  WorldSetup setup;
  setup.ground = terrain::makeLandWithStrips(terrain::makeNoiseHeightSource({}, seed), {.density = 1}, seed);
  setup.seed = seed;
  setup.hasTargets = false;
  setup.gear = flight::GearSettings{};
  setup.wind = wind;
  const auto strip = setup.ground->strips()->nearest({0, 0}, 60000);
  if (!strip) return out;
  setup.start.position = {strip->middle.x, 500, strip->middle.y};
  World world(setup);
  AutopilotSettings settings;
  settings.landEvery = 1;
  Autopilot pilot(setup.ground, settings);
  bool rolled = false;
  for (int i = 0; i < static_cast<int>(seconds * 120); ++i) {
    world.step(pilot.decide(world.now()));
    const GearSnapshot& gear = world.now().aircraft.gear;
    if (gear.wheelsDown > 0 && gear.groundSpeedMps > 20) rolled = true;
    if (rolled && gear.wheelsDown > 0 && gear.groundSpeedMps < 0.2) ++out.landings, rolled = false;
    for (const GameEvent& event : world.takeEvents()) {
      if (event.kind == GameEventKind::touchedDown) out.hardest = std::max(out.hardest, event.sinkRate);
      if (event.kind == GameEventKind::tookOff) ++out.takeOffs, rolled = false;
      if (event.kind == GameEventKind::crashed) ++out.crashes, out.reason = gear.endReason;
    }
  }
  return out;
}

Circuits fliesSeeds(int seeds, double seconds, const glm::dvec3& wind) {
  Circuits all;
  for (int seed = 1; seed <= seeds; ++seed) {
    const Circuits one = fliesCircuits(static_cast<std::uint64_t>(seed), seconds, wind);
    all.landings += one.landings, all.takeOffs += one.takeOffs, all.crashes += one.crashes;
    all.reached += one.landings > 0 ? 1 : 0;
    all.hardest = std::max(all.hardest, one.hardest);
    if (!one.reason.empty()) all.reason += std::to_string(seed) + ": " + one.reason + "; ";
  }
  std::printf(
      "wind %.0f m/s: %d seeds, %d with landings, %d landings, %d take-offs, %d crashes, hardest %.2f m/s "
      "%s\n",
      wind.x, seeds, all.reached, all.landings, all.takeOffs, all.crashes, all.hardest, all.reason.c_str());
  return all;
}

TEST(LandingPilot, inACalmItLandsWithoutDamage) {
  // Six seeds (40 under SKYDROP_SOAK=1), 400 s each: five in six of them land, none breaks anything.
  const int seeds = test::soaking() ? 40 : 6;
  const Circuits all = fliesSeeds(seeds, 400, glm::dvec3(0));
  EXPECT_GE(6 * all.reached, 5 * seeds - 6);
  EXPECT_GE(all.takeOffs, all.reached);
  EXPECT_EQ(all.crashes, 0) << all.reason;
  EXPECT_LT(all.hardest, 2.5);
}

TEST(LandingPilot, fromAStandItTakesOffFirst) {
  // On a strip, asked for circuits: off the ground within 20 s, without a scratch.
  WorldSetup setup;
  setup.ground = terrain::makeLandWithStrips(terrain::makeNoiseHeightSource({}, 1), {.density = 1}, 1);
  setup.hasTargets = false;
  setup.gear = flight::GearSettings{};
  const auto strip = setup.ground->strips()->nearest({0, 0}, 60000);
  ASSERT_TRUE(strip);
  const glm::dvec2 begin = strip->world(25 - strip->halfLength, 0);
  setup.start = {.position = {begin.x, 0, begin.y}, .onWheels = true};
  setup.start.headingDeg = strip->headingRad() * 57.29577951308232;
  World world(setup);
  AutopilotSettings settings;
  settings.landEvery = 1;
  Autopilot pilot(setup.ground, settings);
  for (int i = 0; i < 20 * 120; ++i) world.step(pilot.decide(world.now()));
  EXPECT_EQ(world.now().aircraft.spawnCount, 1u);
  EXPECT_GT(world.now().aircraft.heightAboveGround, 40);
}

TEST(LandingPilot, inACrosswindOfFiveMetresASecondToo) {
  // Wind from the west over strips of any direction: crosswinds of up to 5 m/s.
  const int seeds = test::soaking() ? 40 : 4;
  const Circuits all = fliesSeeds(seeds, 400, glm::dvec3(5, 0, 0));
  EXPECT_GE(3 * all.reached, 2 * seeds - 3);
  EXPECT_LE(all.crashes, seeds / 20) << all.reason;
}

}  // namespace
}  // namespace skydrop::game
