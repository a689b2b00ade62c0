// The gear on the ground: stiff springs, friction at rest, far from the origin.
#include "skydrop/flight/landing_gear.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "skydrop/core/guards.h"
#include "skydrop/core/hash.h"
#include "skydrop/flight/airplane.h"
#include "skydrop/flight/environment.h"
#include "skydrop/flight/rotation.h"
#include "support/margin.h"

namespace skydrop::flight {
namespace {

constexpr double kMass = 1200, kStep = 1.0 / 120;
constexpr double kRad = 0.017453292519943295;

// The aircraft's body on its gear, under gravity alone: no air that could take energy.
struct Sledge {
  GearSettings settings;
  LandingGear gear{settings};
  RigidBody body{kMass, glm::dvec3(0), glm::dquat(1, 0, 0, 0),
                 glm::dmat3(2100, 0, 0, 0, 3068, 0, 0, 0, 1479)};
  GroundPatch plane;
  GearInput input;
  double step = kStep;

  void place(const BodyState& state) {
    body.setState(state);
    gear.lift();
  }
  void advance() {
    gear.apply(settings);
    gear.beginStep();
    const double part = step / kGearParts;
    for (int i = 0; i < kGearParts; ++i) {
      gear.meet(body.state(), input, [this](const glm::dvec2&) { return plane; });
      body.update(part, [this](const BodyState& at, double seconds) {
        Wrench w = gear.wrench(at, seconds);
        w.force.y -= kMass * kGravity;
        return w;
      });
      gear.settle(body.state(), part);
    }
  }
  // Over the plane's height at its middle, J.
  double energy() const {
    return body.kineticEnergy() + kMass * kGravity * body.position().y + gear.springEnergy();
  }
};

BodyState standing(double height, double pitchRad = 0.24, double bankRad = 0) {
  BodyState s;
  s.position = {0, height, 0};
  s.orientation = orientationOf({0, pitchRad, bankRad});
  return s;
}

TEST(Stability, P30_aGearOfAnyStiffnessTakesEnergyAndComesToRest) {
  // Dropped at 3 m/s with a bank of 3 degrees on springs 1, 8, 64 and 512 times as stiff as shipped, and on
  // shipped ones in steps 8 times as long: the energy never grows by more than 1 % of what there was (tyres
  // hold a little that is not counted), and after 30 s nothing moves faster than 1 mm/s.
  for (const auto& [stiffer, longer] :
       {std::pair(1.0, 1), std::pair(8.0, 1), std::pair(64.0, 1), std::pair(512.0, 1), std::pair(1.0, 8)}) {
    Sledge sledge;
    sledge.settings.stiffness *= stiffer;
    sledge.step = kStep * longer;
    BodyState start = standing(1.7, 0.1, 0.05);
    start.velocity = {0, -3, 0};
    sledge.place(start);
    core::resetGuardCounts();
    const double first = sledge.energy();
    double least = first;
    for (int i = 0; i < static_cast<int>(30 / sledge.step); ++i) {
      sledge.advance();
      const double now = sledge.energy();
      ASSERT_TRUE(test::holds("P30", now - least, test::below(0.01 * kMass * 9), "J that come from nothing"))
          << stiffer << " times, step " << i;
      least = std::min(least, now);
    }
    EXPECT_TRUE(test::holds("P30", glm::length(sledge.body.velocity()), test::below(1e-3), "m/s at the end"))
        << stiffer << " times as stiff, steps of " << longer;
    EXPECT_LT(glm::length(sledge.body.state().angularVelocity), 1e-3) << stiffer;
    EXPECT_EQ(sledge.gear.wheelsDown(), 3) << stiffer;
    EXPECT_EQ(core::guardCount(core::Guard::notFiniteState), 0u);
  }
}

TEST(Stability, P31_brakesHoldOnASlopeWithoutCreeping) {
  // Along and across slopes of 2, 8 and 15 degrees: from the 30th second to the 50th the aircraft moves by
  // less than 1 um, at which an hour is a fifth of a millimetre. A friction that needs slip to hold would
  // creep by centimetres a second.
  for (const double slopeDeg : {2.0, 8.0, 15.0}) {
    for (const bool across : {false, true}) {
      const double slope = std::tan(slopeDeg * kRad);
      Sledge sledge;
      sledge.input.brake = 1;
      sledge.plane.gradient = across ? glm::dvec2(slope, 0) : glm::dvec2(0, slope);
      const double lean = slopeDeg * kRad;
      sledge.place(across ? standing(1.4, 0.24, -lean) : standing(1.4, 0.24 - lean));
      for (int i = 0; i < 30 * 120; ++i) sledge.advance();
      const glm::dvec3 before = sledge.body.position();
      for (int i = 0; i < 20 * 120; ++i) sledge.advance();
      EXPECT_TRUE(
          test::holds("P31", glm::length(sledge.body.position() - before), test::below(1e-6), "m in 20 s"))
          << slopeDeg << (across ? " across" : "");
      EXPECT_EQ(sledge.gear.wheelsDown(), 3);
    }
  }
}

TEST(Stability, P32_frictionGoesToZeroWithTheSpeed) {
  // Standing on its springs and pushed sideways or ahead at 1, 1e-3 .. 1e-12 m/s, the friction of a fresh
  // contact shrinks in proportion, and vanishes at rest: no sign function that flips with rounding.
  for (const glm::dvec3 way : {glm::dvec3(1, 0, 0), glm::dvec3(0, 0, -1)}) {
    const auto friction = [&](double speed) {
      Sledge sledge;
      sledge.input.brake = 1;
      BodyState s = standing(1.29);
      s.velocity = way * speed;
      sledge.place(s);
      sledge.gear.meet(s, sledge.input, [&](const glm::dvec2&) { return sledge.plane; });
      const Wrench w = sledge.gear.wrench(s, 0);
      return std::abs(glm::dot(w.force, way));
    };
    const double unit = friction(1e-3) / 1e-3;
    EXPECT_GT(unit, 0);
    for (double speed = 1e-5; speed > 1e-13; speed *= 0.1)
      EXPECT_TRUE(test::holds("P32", test::apart(friction(speed) / (unit * speed), 1), test::atMost(0.02),
                              "of proportional friction"))
          << speed;
    EXPECT_EQ(friction(0), 0);
    EXPECT_LE(friction(1), 0.75 * kMass * kGravity) << "no more than the tyres' friction";
  }
}

TEST(Stability, P33_farFromTheOriginItSettlesAlike) {
  // At 1e7 m (an ulp of 2e-9 m) the rest after 20 s is within 1 um of that at the origin, and as still.
  const auto rest = [](double x) {
    Sledge sledge;
    BodyState s = standing(1.5);
    s.position.x = x;
    sledge.plane.at = {x, 0};
    sledge.place(s);
    for (int i = 0; i < 20 * 120; ++i) sledge.advance();
    return sledge.body.state();
  };
  const BodyState near = rest(0), far = rest(1e7);
  EXPECT_TRUE(test::holds("P33", test::apart(near.position.y, far.position.y), test::atMost(1e-6), "m"));
  EXPECT_TRUE(
      test::holds("P33", test::apart(near.orientation.x, far.orientation.x), test::atMost(1e-6), "1"));
  EXPECT_LT(glm::length(far.velocity), 1e-6);
}

TEST(Stability, P34_anyAttitudeOnTheGroundStaysFinite) {
  // 300 throws at up to 40 m/s in any attitude onto ground of up to 40 degrees, gear whole: three seconds
  // later all is finite, the energy has grown by at most 5 %, and nothing was refused.
  core::RandomStream random{7, 0};
  core::resetGuardCounts();
  for (int n = 0; n < 300; ++n) {
    Sledge sledge;
    const auto unit = [&] { return 2 * random.nextUnit() - 1; };
    sledge.plane.gradient = {0.6 * unit(), 0.6 * unit()};
    BodyState s;
    s.position = {0, 7, 0};
    s.orientation = glm::normalize(glm::dquat(unit(), unit(), unit(), unit()));
    s.velocity = glm::dvec3(40 * unit(), -20 * random.nextUnit(), 40 * unit());
    s.angularVelocity = {2 * unit(), 2 * unit(), 2 * unit()};
    sledge.place(s);
    const double energy = sledge.energy();
    for (int i = 0; i < 3 * 120; ++i) sledge.advance();
    ASSERT_TRUE(core::isFinite(sledge.body.position()) && core::isFinite(sledge.body.velocity())) << n;
    ASSERT_TRUE(test::holds("P34", sledge.energy() / energy - 1, test::below(0.05),
                            "of the energy at first, that come from nothing"))
        << n;
  }
  EXPECT_EQ(core::guardCount(core::Guard::notFiniteState), 0u);
}

}  // namespace
}  // namespace skydrop::flight
