// The aircraft on its gear over level ground, by its numbers.
#include "skydrop/flight/landing_gear.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "skydrop/flight/airplane.h"
#include "skydrop/flight/environment.h"
#include "skydrop/flight/rotation.h"

namespace skydrop::flight {
namespace {

constexpr double kStep = 1.0 / 120, kDegree = 0.017453292519943295;

struct Rig {
  GroundPatch plane;
  AirplaneInput input{.idles = true};
  GearInput wheels;
  LandingGear legs{GearSettings{}};
  Airplane airplane{AirplaneSettings{}, {}};

  void place(double height, double speed, double pitchDeg) {
    BodyState s;
    s.position = {0, height, 0};
    s.velocity = {0, 0, -speed};
    s.orientation = orientationOf({0, pitchDeg * kDegree, 0});
    airplane.place(s);
    airplane.setThrottle(0);
    legs.lift();
  }
  void stand() {
    place(1.3, 0, 13.7);
    run(4);
  }
  void run(double seconds) {
    for (int i = 0; i < std::lround(seconds / kStep); ++i)
      airplane.stepOnGround(input, {}, kStep, legs, wheels, [&](const glm::dvec2&) { return plane; });
  }
  const BodyState& body() const { return airplane.body().state(); }
  double speed() const { return glm::length(body().velocity); }
  double headingDeg() const { return attitudeOf(body().orientation).headingRad / kDegree; }
};

TEST(LandingGear, standsWhereTheModelStands) {
  // Its middle 1.289 m over the ground, the nose 13.73 degrees up, the wheels bear the weight within 1 N; the
  // springs give way by the 8 and 9 cm by which the model's wheels stand higher than the free ones.
  Rig rig;
  rig.stand();
  EXPECT_NEAR(rig.body().position.y, 1.2893, 5e-4);
  EXPECT_NEAR(attitudeOf(rig.body().orientation).pitchRad / kDegree, 13.73, 0.01);
  double force = 0;
  for (std::size_t i = 0; i < kWheels; ++i) force += rig.legs.loads()[i].force;
  EXPECT_NEAR(force, 1200 * kGravity, 1);
  EXPECT_NEAR(rig.legs.loads()[0].compression, 0.076, 0.002);
  EXPECT_NEAR(rig.legs.loads()[2].compression, 0.089, 0.002);
  EXPECT_LT(rig.speed(), 1e-4);
}

TEST(LandingGear, takesOffWithin200MetresAndStopsWithin300) {
  Rig rig;
  rig.stand();
  rig.input.thrust = 1;
  int steps = 0;
  while (rig.legs.wheelsDown() > 0 && ++steps < 30 * 120) {
    rig.input.pitch = rig.speed() > 36 ? 0.3 : 0;
    rig.run(kStep);
  }
  EXPECT_LT(-rig.body().position.z, 200) << "the run";
  EXPECT_NEAR(rig.speed(), 38, 5) << "flies off";

  Rig landing;
  landing.place(1.65, 34, 1);
  landing.wheels.brake = 0;
  landing.run(1);
  for (int i = 0; i < 30 * 120 && landing.speed() > 0.1; ++i) {
    const double pitch = attitudeOf(landing.body().orientation).pitchRad;
    landing.wheels.brake = std::clamp((pitch + 0.05) / 0.17, 0.0, 1.0);
    landing.run(kStep);
  }
  EXPECT_LT(landing.speed(), 0.1);
  EXPECT_LT(-landing.body().position.z, 300) << "from the touch-down";
}

TEST(LandingGear, theYawKeysSteerAtWalkingPace) {
  // Full right at 3 m/s turns right, on a circle of 7 to 12 m radius; full left to the left, alike.
  for (const double way : {1.0, -1.0}) {
    Rig rig;
    rig.stand();
    BodyState rolling = rig.body();
    rolling.velocity = {0, 0, -3};
    rig.airplane.place(rolling);
    rig.airplane.setThrottle(0.06);
    rig.wheels.steer = way;
    rig.input.thrust = 0.07;
    rig.run(1);
    const double before = rig.headingDeg();
    rig.run(1);
    const double turned = std::remainder(rig.headingDeg() - before, 360);
    EXPECT_GT(way * turned, 5);
    EXPECT_NEAR(rig.speed() / (std::abs(turned) * kDegree), 9.5, 2.5);
  }
}

TEST(LandingGear, aTyreHoldsNoMoreThanItsFriction) {
  // Slid sideways at 8 m/s, it decelerates with .7 g within 10 %, and heels but does not turn over.
  Rig rig;
  rig.stand();
  BodyState sliding = rig.body();
  sliding.velocity = {8, 0, 0};
  rig.airplane.place(sliding);
  rig.airplane.setThrottle(0);
  rig.run(0.3);
  const double first = rig.body().velocity.x;
  rig.run(0.2);
  EXPECT_NEAR((first - rig.body().velocity.x) / 0.2, 0.7 * kGravity, 0.15 * kGravity);
}

TEST(LandingGear, rollsOutByItselfAtIdle) {
  // Hands off from 5 m/s on a meadow (.07) it stops within 25 m.
  Rig rig;
  rig.stand();
  rig.plane.rolling = 0.07;
  BodyState rolling = rig.body();
  rolling.velocity = {0, 0, -5};
  rig.airplane.place(rolling);
  rig.airplane.setThrottle(0);
  rig.run(9);
  EXPECT_LT(rig.speed(), 0.01);
  EXPECT_LT(-rig.body().position.z, 25);
}

TEST(LandingGear, aBrokenLegBearsNothing) {
  Rig rig;
  rig.stand();
  rig.legs.breakLegs();
  rig.run(4);
  EXPECT_EQ(rig.legs.wheelsDown(), 0);
  EXPECT_NEAR(rig.body().position.y, 0.6, 0.15) << "it lies on its belly";
}

}  // namespace
}  // namespace skydrop::flight
