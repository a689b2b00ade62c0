// What helps the pilot: turns that keep height and bank, and the warning of ground ahead.
#include "skydrop/game/flight_assist.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include "skydrop/game/world.h"
#include "skydrop/terrain/analytic_height_sources.h"
#include "skydrop/terrain/noise_height_source.h"
#include "support/margin.h"

namespace skydrop::game {
namespace {

constexpr double kDegrees = 57.29577951308232;

std::shared_ptr<const terrain::HeightSource> land() {
  static const auto source = terrain::makeNoiseHeightSource(terrain::TerrainSettings(), 1);
  return source;
}

WorldSetup overFlat() {
  WorldSetup setup;
  setup.ground = terrain::makeFlatSource(10);
  setup.hasTargets = false;
  return setup;
}

struct Turn {
  double highest = 0, lowest = 0, mostBankDeg = 0, turnedDeg = 0;
};

// A minute of turn, then the key is let go for 10 s.
Turn turned(double roll, const AssistSettings& settings, const glm::dvec3& wind = glm::dvec3(0)) {
  WorldSetup setup = overFlat();
  setup.wind = wind;
  World world(setup);
  FlightAssist assist;
  Turn turn;
  const double start = world.now().aircraft.position.y;
  double last = world.now().aircraft.headingRad;
  for (int i = 0; i < 120 * 70; ++i) {
    const Controls player{.roll = i < 120 * 60 ? roll : 0};
    world.step(assist.decide(world.now(), player, settings));
    const AircraftSnapshot& craft = world.now().aircraft;
    turn.highest = std::max(turn.highest, craft.position.y - start);
    turn.lowest = std::min(turn.lowest, craft.position.y - start);
    turn.mostBankDeg = std::max(turn.mostBankDeg, std::abs(craft.bankRad) * kDegrees);
    turn.turnedDeg += std::abs(std::remainder(craft.headingRad - last, 6.283185307179586)) * kDegrees;
    last = craft.headingRad;
  }
  EXPECT_LT(std::abs(world.now().aircraft.bankRad) * kDegrees, 3) << "the wings are level again";
  return turn;
}

TEST(FlightAssist, G06_aMinuteOfTurnKeepsTheHeightAndTheBank) {
  // Left and right, gentle and full, at three limits, in wind too: within 3 m of the height, never above the
  // limit.
  for (const double limit : {20.0, 45.0, 60.0}) {
    for (const double roll : {1.0, -1.0, 0.4}) {
      const Turn turn = turned(roll, {.maxBankDeg = limit});
      std::printf("limit %.0f, roll %.1f: %.1f .. %.1f m, bank %.2f, %.0f degrees\n", limit, roll,
                  turn.lowest, turn.highest, turn.mostBankDeg, turn.turnedDeg);
      EXPECT_TRUE(test::holds("G06", std::max(turn.highest, -turn.lowest), test::atMost(3), "m"));
      EXPECT_LE(turn.mostBankDeg, limit) << roll;
      EXPECT_GT(turn.turnedDeg, 60 * std::abs(roll) * limit / 20) << "it turns";
    }
  }
  EXPECT_LE(turned(1, {}, {9, 0, 3}).mostBankDeg, 45);
}

TEST(FlightAssist, expertModeHandsOnWhatThePlayerDoes) {
  // With turns off every control is the player's own, and so is every state of the flight.
  World direct(overFlat()), through(overFlat());
  FlightAssist assist;
  for (int i = 0; i < 120 * 40; ++i) {
    const Controls player{.thrust = i % 700 < 200 ? 1.0 : 0.0,
                          .pitch = i % 500 < 90 ? 0.4 : 0.0,
                          .roll = i % 900 < 200 ? 0.7 : 0.0};
    direct.step(player);
    through.step(assist.decide(through.now(), player, {.turns = false}));
    if (i % 120 == 0) {
      ASSERT_EQ(direct.stateHash(), through.stateHash()) << "step " << i;
    }
  }
  EXPECT_EQ(direct.stateHash(), through.stateHash());
}

TEST(FlightAssist, handsOffNothingIsChanged) {
  // Who never rolls flies as ever: headless runs, and a player who climbs.
  World direct(overFlat()), through(overFlat());
  FlightAssist assist;
  for (int i = 0; i < 120 * 20; ++i) {
    const Controls player{.thrust = 0.5, .pitch = i > 600 && i < 700 ? 0.5 : 0.0};
    direct.step(player);
    through.step(assist.decide(through.now(), player, {}));
  }
  EXPECT_EQ(direct.stateHash(), through.stateHash());
}

TEST(FlightAssist, aPullInATurnClimbsAndTheNewHeightIsKept) {
  World world(overFlat());
  FlightAssist assist;
  double height = 0;
  for (int i = 0; i < 120 * 40; ++i) {
    const bool pulls = i > 600 && i < 1100;
    world.step(assist.decide(world.now(), {.pitch = pulls ? 0.6 : 0.0, .roll = 0.6}, {}));
    if (i == 120 * 15) height = world.now().aircraft.position.y;
  }
  EXPECT_GT(height, 520) << "it has climbed";
  EXPECT_NEAR(world.now().aircraft.position.y, height, 40);
}

std::optional<double> warned(const AircraftSnapshot& craft, const terrain::HeightSource& ground) {
  return secondsToGround(ground, craft, 6);
}

TEST(TerrainWarning, G07_comesInTimeAtTheShippedLand) {
  // Straight on at 70 m/s over the shipped land, level and in dives of 5 and 15 degrees, from 36 places:
  // where the flight ends in the ground, the warning has stood for at least 4 s of it, or from the start on.
  int crashes = 0;
  double least = 1e9;
  for (int i = 0; i < 36; ++i) {
    WorldSetup setup;
    setup.ground = land();
    setup.hasTargets = false;
    setup.start.position = {i * 1700.0 - 40000, 120.0 + 5 * (i % 20), i * 900.0};
    setup.start.headingDeg = 37.0 * i;
    setup.start.pitchDeg = i % 3 == 0 ? 0 : i % 3 == 1 ? -5 : -15;
    World world(setup);
    std::optional<std::uint64_t> since;
    for (int step = 0; step < 120 * 60 && !world.now().aircraft.crashed; ++step) {
      if (step % 6 != 0) {
        // asked 20 times a second
      } else if (warned(world.now().aircraft, *setup.ground)) {
        if (!since) since = world.stepCount();
      } else {
        since.reset();
      }
      world.step({.pitch = i % 3 == 2 ? -0.35 : 0.0});
    }
    if (!world.now().aircraft.crashed) continue;
    ++crashes;
    ASSERT_TRUE(since) << i;
    if (*since < 60) continue;  // it began too low
    least = std::min(least, static_cast<double>(world.stepCount() - *since) / 120);
  }
  std::printf("%d flights end in the ground, the shortest warning stands %.2f s\n", crashes, least);
  EXPECT_GT(crashes, 10);
  EXPECT_TRUE(test::holds("G07", least, test::atLeast(3), "s"));
}

TEST(TerrainWarning, isSilentHighUpAndForWhatIsNoNumber) {
  const WorldSetup setup = overFlat();
  World world(setup);
  AircraftSnapshot craft = world.now().aircraft;
  const terrain::HeightSource& ground = *setup.ground;
  EXPECT_FALSE(warned(craft, ground));
  craft.position.y = 60;
  EXPECT_FALSE(warned(craft, ground)) << "level over flat land";
  craft.velocity.y = -20;
  ASSERT_TRUE(warned(craft, ground));
  EXPECT_NEAR(*warned(craft, ground), 2.5, 0.2);
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    AircraftSnapshot wrong = craft;
    wrong.velocity.y = bad;
    EXPECT_FALSE(warned(wrong, ground));
    wrong = craft;
    wrong.position.x = bad;
    EXPECT_FALSE(warned(wrong, ground));
    wrong = craft;
    wrong.bankRad = bad;
    EXPECT_FALSE(warned(wrong, ground));
    EXPECT_FALSE(secondsToGround(ground, craft, std::numeric_limits<double>::quiet_NaN()));
  }
  craft.crashed = true;
  EXPECT_FALSE(warned(craft, ground));
}

TEST(TerrainWarning, letsOneLand) {
  World world(overFlat());
  AircraftSnapshot craft = world.now().aircraft;
  craft.position.y = 14;
  craft.velocity.y = -2;
  EXPECT_TRUE(warned(craft, *overFlat().ground)) << "without a gear the ground is the end";
  craft.gear.present = true;
  EXPECT_FALSE(warned(craft, *overFlat().ground));
  craft.velocity.y = -8;
  EXPECT_TRUE(warned(craft, *overFlat().ground));
}

}  // namespace
}  // namespace skydrop::game
