#include "skydrop/flight/airplane.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/mat3x3.hpp>
#include <limits>
#include <numbers>
#include <vector>

#include "skydrop/core/error.h"
#include "skydrop/core/guards.h"
#include "skydrop/core/hash.h"
#include "skydrop/flight/environment.h"
#include "skydrop/flight/rotation.h"
#include "support/margin.h"
#include "support/soak.h"

namespace skydrop::flight {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
const glm::dvec3 kCalm{0};

BodyState flyingNorth(double speed) {
  BodyState state;
  state.position = {0, 1000, 0};
  state.velocity = {0, 0, -speed};
  return state;
}

bool isFinite(const BodyState& s) {
  return core::isFinite(s.position) && core::isFinite(s.velocity) && core::isFinite(s.angularVelocity) &&
         std::isfinite(s.orientation.w) && std::isfinite(s.orientation.x) && std::isfinite(s.orientation.y) &&
         std::isfinite(s.orientation.z);
}

TEST(Stability, P04_anHourOfScriptedFlightStaysFinite) {
  // One simulated hour (ten when soaking) with random sticks that jump every half second: everything stays
  // finite, the attitude unit within 1e-12, the speed below what a vertical dive can reach.
  Airplane airplane({}, flyingNorth(70));
  core::RandomStream random{5, 0};
  AirplaneInput input;
  const int seconds = test::soaking() ? 36000 : 3600;
  double fastest = 0;
  for (int i = 0; i < seconds * 120; ++i) {
    if (i % 60 == 0) {
      const auto stick = [&] { return std::floor(random.nextUnit() * 3) - 1; };
      input = {.thrust = random.nextUnit(), .brake = 0, .pitch = stick(), .roll = stick(), .yaw = stick()};
    }
    airplane.step(input, kCalm, 1.0 / 120);
    fastest = std::max(fastest, glm::length(airplane.body().velocity()));
  }
  EXPECT_TRUE(isFinite(airplane.body().state()));
  EXPECT_TRUE(test::holds("P04", test::apart(glm::length(airplane.body().orientation()), 1),
                          test::atMost(1e-12), "of length 1"));
  EXPECT_LT(fastest, 220);  // m/s: thrust and weight against drag, straight down
}

TEST(Stability, P04_noAircraftClimbsOutOfTheWorldThatIsDrawn) {
  // Ten minutes upwards with the strongest engine that can be set, from just below the thin air: it stays
  // below the ceiling, and comes down again when the engine idles.
  test::noFaults("P04", "violations");
  AirplaneSettings settings;
  settings.maxThrottle = 1000;
  BodyState start = flyingNorth(250);
  start.position.y = kThinAirFrom - 1000;
  Airplane airplane(settings, start);
  double highest = 0;
  for (int i = 0; i < 600 * 120; ++i) {
    airplane.step({.thrust = 1, .pitch = 0.5}, kCalm, 1.0 / 120);
    highest = std::max(highest, airplane.body().position().y);
  }
  EXPECT_TRUE(isFinite(airplane.body().state()));
  EXPECT_GT(highest, kThinAirFrom);
  EXPECT_LT(highest, kCeiling);
  for (int i = 0; i < 300 * 120; ++i) airplane.step({.brake = 1}, kCalm, 1.0 / 120);
  EXPECT_LT(airplane.body().position().y, kThinAirFrom);
}

double terminalSpeed(Integrator integrator, int rate) {
  AirplaneSettings settings;
  settings.integrator = integrator;
  Airplane airplane(settings, flyingNorth(70));
  for (int i = 0; i < 200 * rate; ++i) airplane.step({.thrust = 1}, kCalm, 1.0 / rate);
  return glm::length(airplane.body().velocity());
}

TEST(Stability, P08_terminalSpeedDoesNotDependOnTheStep) {
  // Full throttle until steady at 8 to 240 Hz: the same 120 m/s within .01 %.
  const double reference = terminalSpeed(Integrator::rkmk4, 480);
  EXPECT_TRUE(test::holds("P08", test::apart(reference, 120), test::atMost(0.012), "m/s"));
  for (const Integrator integrator : {Integrator::rk4, Integrator::rkmk4}) {
    for (const int rate : {8, 10, 15, 30, 60, 120, 240}) {
      EXPECT_TRUE(test::holds("P08", test::apart(terminalSpeed(integrator, rate) / reference, 1),
                              test::atMost(1e-4), "relative"))
          << rate;
    }
  }
}

// A damped swing about the pitch axis: acceleration -w^2 angle - 2 d w rate. The angle after `seconds`,
// started at .1 rad at rest.
double swingAfter(double w, double d, double seconds, int rate) {
  RigidBody body(1, glm::dvec3(0), glm::dquat(1, 0, 0, 0), glm::dmat3(7));
  BodyState start;
  start.orientation = exponentialMap({0.1, 0, 0});
  body.setState(start);
  const int steps = static_cast<int>(std::lround(seconds * rate));
  for (int i = 0; i < steps; ++i) {
    body.update(seconds / steps, [&](const BodyState& s) {
      return Wrench{glm::dvec3(0),
                    -7.0 * (w * w * logarithmMap(s.orientation) + 2 * d * w * s.angularVelocity)};
    });
  }
  return logarithmMap(body.orientation()).x;
}

TEST(Stability, P09_stiffModesDecayRightAtTheShippedStepAndStayStableAtEightTimesIt) {
  // Short periods of 8 and 20 rad/s with a damping ratio of .3: at 120 Hz the swing is within 1 % (of its
  // envelope) of the closed form after a second; at 15 Hz it has died down after 20 s instead of growing.
  for (const double w : {8.0, 20.0}) {
    const double d = 0.3, damped = w * std::sqrt(1 - d * d);
    const double envelope = 0.1 * std::exp(-d * w) / std::sqrt(1 - d * d);
    const double truth = 0.1 * std::exp(-d * w) * (std::cos(damped) + d * w / damped * std::sin(damped));
    EXPECT_TRUE(test::holds("P09", test::apart(swingAfter(w, d, 1, 120), truth),
                            test::atMost(0.01 * envelope), "of the swing"))
        << w;
    EXPECT_TRUE(
        test::holds("P09", std::abs(swingAfter(w, d, 20, 15)), test::below(0.1 * 1e-3), "of the swing"))
        << w;
  }
}

TEST(Stability, P09_rollRateDecaysRightWithATimeConstantOfATwentiethOfASecond) {
  // Roll damping alone, 20 1/s: after .1 s the rate is exp(-2) of itself within 1 % at 120 Hz, and at 15 Hz
  // it dies.
  for (const int rate : {120, 15}) {
    RigidBody body(1, glm::dvec3(0), glm::dquat(1, 0, 0, 0), glm::dmat3(1));
    BodyState start;
    start.angularVelocity = {0, 0, 2};
    body.setState(start);
    const double seconds = rate == 120 ? 0.1 : 2;
    for (int i = 0; i < static_cast<int>(std::lround(seconds * rate)); ++i) {
      body.update(1.0 / rate, [](const BodyState& s) {
        return Wrench{glm::dvec3(0), -20.0 * s.angularVelocity};
      });
    }
    EXPECT_TRUE(test::holds("P09", test::apart(body.state().angularVelocity.z, 2 * std::exp(-20 * seconds)),
                            test::atMost(0.01 * 2 * std::exp(-2)), "rad/s"))
        << rate;
  }
}

TEST(Stability, P09_theAircraftTunedStiffFliesAtEightTimesTheStep) {
  // Tail and fin at 20 rad/s (400 1/s^2), roll damping 20 1/s: a pull, a roll and a skid at 15 Hz end in the
  // same attitude as at 120 Hz, within .1 degrees.
  AirplaneSettings settings;
  settings.pitchStiffness = settings.yawStiffness = 400;
  settings.rollDamping = 20;
  std::vector<Attitude> ends;
  for (const int rate : {120, 15}) {
    Airplane airplane(settings, flyingNorth(70));
    for (int i = 0; i < 60 * rate; ++i) {
      const double t = static_cast<double>(i) / rate;
      airplane.step({.pitch = t < 2 ? 1.0 : 0.0, .roll = t < 4 ? 1.0 : 0.0, .yaw = t < 6 ? -1.0 : 0.0}, kCalm,
                    1.0 / rate);
      ASSERT_LT(glm::length(airplane.body().state().angularVelocity), 5) << rate << " Hz at " << t;
    }
    ends.push_back(attitudeOf(airplane.body().orientation()));
  }
  EXPECT_TRUE(test::holds("P09", test::apart(ends[0].bankRad * kDegrees, ends[1].bankRad * kDegrees),
                          test::atMost(0.1), "degrees"));
  EXPECT_TRUE(test::holds("P09", test::apart(ends[0].pitchRad * kDegrees, ends[1].pitchRad * kDegrees),
                          test::atMost(0.1), "degrees"));
  EXPECT_TRUE(test::holds("P09", test::apart(ends[0].bankRad * kDegrees, 0), test::atMost(1), "degrees"));
}

TEST(Stability, P10_attitudeReadsRightAtEveryHeadingUpToNearlyStraightUp) {
  // The body's axes built from the angles by plain geometry in long double; the read-out gives the angles
  // back within 1e-4 degrees at every heading, for pitches to 89.9 degrees and all banks.
  const long double rad = std::numbers::pi_v<long double> / 180;
  for (int heading = 0; heading < 360; heading += 15) {
    for (const double pitch : {-89.9, -45.0, 0.0, 30.0, 80.0, 89.9}) {
      for (const double bank : {10.0, -10.0, 0.0, 90.0, 179.0, -135.0}) {
        const long double h = heading * rad, p = pitch * rad, b = bank * rad;
        using V = glm::tvec3<long double>;
        const V north(0, 0, -1), east(1, 0, 0), up(0, 1, 0);
        const V ahead = north * cosl(h) + east * sinl(h), right = east * cosl(h) - north * sinl(h);
        const V forward = ahead * cosl(p) + up * sinl(p), top = up * cosl(p) - ahead * sinl(p);
        const V wing = right * cosl(b) - top * sinl(b), roof = top * cosl(b) + right * sinl(b);
        const glm::dmat3 axes(glm::dvec3(wing), glm::dvec3(roof), -glm::dvec3(forward));
        const Attitude read = attitudeOf(glm::normalize(glm::quat_cast(axes)));
        const auto apart = [](double a, double b2) { return std::remainder(a - b2, 360.0); };
        EXPECT_TRUE(test::holds("P10", test::apart(apart(read.headingRad * kDegrees, heading), 0),
                                test::atMost(1e-4), "degrees"))
            << pitch << " " << bank;
        EXPECT_TRUE(
            test::holds("P10", test::apart(read.pitchRad * kDegrees, pitch), test::atMost(1e-4), "degrees"))
            << heading << " " << bank;
        EXPECT_TRUE(test::holds("P10", test::apart(apart(read.bankRad * kDegrees, bank), 0),
                                test::atMost(1e-4), "degrees"))
            << heading << " " << pitch;
      }
    }
  }
}

TEST(Stability, P11_everyAttitudeGivesAnOrthonormalFrameAndFiniteAngles) {
  // Straight up, straight down, on the back and 10 000 random attitudes: the rotation is orthonormal within
  // 1e-6 with determinant 1, the angles are finite, and orientationOf gives the same rotation back within
  // 1e-6.
  core::RandomStream random{3, 0};
  for (int i = 0; i < 10000; ++i) {
    Attitude pose{random.nextUnit() * 6.28, (random.nextUnit() - 0.5) * 3.14,
                  (random.nextUnit() - 0.5) * 6.28};
    if (i % 4 == 0) pose.pitchRad = (i % 8 ? 1 : -1) * std::numbers::pi / 2;
    if (i % 5 == 0) pose.bankRad = std::numbers::pi;
    const glm::dquat q = orientationOf(pose);
    const glm::dmat3 m = glm::mat3_cast(q);
    const glm::dmat3 unit = glm::transpose(m) * m;
    for (int column = 0; column < 3; ++column) {
      for (int row = 0; row < 3; ++row)
        EXPECT_TRUE(test::holds("P11", test::apart(unit[column][row], column == row ? 1 : 0),
                                test::atMost(1e-6), "of a unit matrix"));
    }
    EXPECT_TRUE(
        test::holds("P11", test::apart(glm::determinant(m), 1), test::atMost(1e-6), "of a unit matrix"));
    const Attitude read = attitudeOf(q);
    ASSERT_TRUE(std::isfinite(read.headingRad) && std::isfinite(read.pitchRad) &&
                std::isfinite(read.bankRad));
    EXPECT_TRUE(
        test::holds("P11", glm::length(logarithmMap(glm::normalize(glm::conjugate(q) * orientationOf(read)))),
                    test::below(1e-6), "rad"));
  }
}

TEST(Stability, P12_stepsOfNoTimeOrNonsenseLeaveTheAircraftAsItWas) {
  // dt = 0, negative, NaN, infinite: position, throttle and attitude keep every bit.
  test::noFaults("P12", "violations");
  Airplane airplane({}, flyingNorth(70));
  airplane.step({.thrust = 1, .roll = 1}, kCalm, 1.0 / 120);
  const BodyState before = airplane.body().state();
  const double throttle = airplane.throttle();
  for (const double dt : {0.0, -1.0, kNaN, kInfinity, -kInfinity}) airplane.step({.thrust = 1}, kCalm, dt);
  EXPECT_EQ(airplane.body().position(), before.position);
  EXPECT_EQ(airplane.body().orientation(), before.orientation);
  EXPECT_EQ(airplane.throttle(), throttle);
}

TEST(Stability, P13_unusableSettingsAndPosesAreRefusedAndChangeNothing) {
  // No mass, no wing, NaN anywhere: RangeError at the door, at construction and while flying.
  test::noFaults("P13", "inputs accepted");
  AirplaneSettings noMass, noWing, nanDrag;
  noMass.mass = 0;
  noWing.wingArea = -1;
  nanDrag.dragCoefficient = kNaN;
  Airplane airplane({}, flyingNorth(70));
  for (const AirplaneSettings& settings : {noMass, noWing, nanDrag}) {
    EXPECT_THROW(Airplane(settings, flyingNorth(70)), core::RangeError);
    EXPECT_THROW(airplane.apply(settings), core::RangeError);
  }
  EXPECT_EQ(airplane.settings().mass, 1200);
  BodyState lost = flyingNorth(70);
  lost.velocity.x = kInfinity;
  EXPECT_THROW(airplane.place(lost), core::RangeError);
  EXPECT_EQ(airplane.body().position(), flyingNorth(70).position);
}

TEST(Stability, P19_airForcesVanishContinuouslyAndReversedFlowIsFinite) {
  // At 0, 1e-30, 1e-160 and 1e-3 m/s, forwards, backwards, sideways and from below: forces and torques are
  // finite and without thrust and weight shrink at least with the speed; from behind at 200 m/s they are
  // finite too.
  const AirplaneSettings settings;
  const Airplane airplane(settings, flyingNorth(70));
  const MassProperties& body = airplane.body().properties();
  const glm::dvec3 weight(0, -body.mass * kGravity, 0);
  for (const glm::dvec3& way : {glm::dvec3(0, 0, -1), glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0),
                                glm::dvec3(0, -1, 0), glm::dvec3(-1, 1, 1)}) {
    for (const double speed : {0.0, 1e-160, 1e-30, 1e-9, 1e-3, 200.0}) {
      BodyState state;
      state.velocity = way * speed;
      const Wrench w = airplaneWrench(settings, body, {.pitch = 1, .roll = -1, .yaw = 1}, {}, kCalm, state);
      EXPECT_TRUE(core::isFinite(w.force) && core::isFinite(w.torque)) << speed;
      const Airflow flow = airflowOf(settings, 0, kCalm, state);
      EXPECT_TRUE(std::isfinite(flow.angleOfAttack) && std::isfinite(flow.sideslip) &&
                  std::isfinite(flow.loadFactor));
      if (speed <= 1e-3) {
        // 1e3 kg/m of area, density and coefficients is generous: force < 1e3 v^2.
        EXPECT_TRUE(
            test::holds("P19", glm::length(w.force - weight), test::atMost(1e3 * speed * speed + 1e-11), "N"))
            << speed;
        // Damping against the path's own turning leaves a torque proportional to the speed.
        EXPECT_TRUE(test::holds("P19", glm::length(w.torque), test::atMost(1e4 * speed + 1e-11), "N m"))
            << speed;
      }
    }
  }
}

TEST(Stability, P19_anAircraftThatHangsInTheAirFallsAndFliesOn) {
  // Started without speed, sliding backwards and flat on its back: it falls, picks up speed and flies level
  // again within a minute and 1500 m.
  BodyState still, backwards, onItsBack;
  backwards.velocity = {0, 0, 60};
  onItsBack.orientation = orientationOf({0, 0, std::numbers::pi});
  onItsBack.velocity = {0, 0, -70};
  for (const BodyState& start : {still, backwards, onItsBack}) {
    Airplane airplane({}, start);
    for (int i = 0; i < 60 * 120; ++i) {
      airplane.step({}, kCalm, 1.0 / 120);
      ASSERT_TRUE(isFinite(airplane.body().state()));
    }
    EXPECT_GT(airplane.body().position().y, -1500);
    EXPECT_TRUE(test::holds("P19",
                            test::apart(attitudeOf(airplane.body().orientation()).bankRad * kDegrees, 0),
                            test::atMost(5), "degrees"));
    EXPECT_TRUE(test::holds("P19", test::apart(airplane.body().velocity().y, 0), test::atMost(3), "m/s"));
    EXPECT_TRUE(test::holds("P19", test::apart(glm::length(airplane.body().velocity()), 70), test::atMost(15),
                            "m/s"));
  }
}

}  // namespace
}  // namespace skydrop::flight
