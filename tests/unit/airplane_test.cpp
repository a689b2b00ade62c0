#include "skydrop/flight/airplane.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <numbers>

#include "skydrop/flight/environment.h"
#include "skydrop/flight/rotation.h"

// How it flies from the keyboard: steps of the sticks at 120 Hz, from level cruise at 1000 m towards north.
namespace skydrop::flight {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

struct Flight {
  Airplane airplane;

  explicit Flight(double speed = 70, const AirplaneSettings& settings = {})
      : airplane(settings, start(speed)) {}

  static BodyState start(double speed) {
    BodyState state;
    state.position = {0, 1000, 0};
    state.velocity = {0, 0, -speed};
    return state;
  }
  // Flies on for `seconds`, showing each step to `watch`.
  void fly(
      double seconds, const AirplaneInput& input, const std::function<void()>& watch = [] {}) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds * 120)); ++i) {
      airplane.step(input, glm::dvec3(0), 1.0 / 120);
      watch();
    }
  }
  Attitude attitude() const { return attitudeOf(airplane.body().orientation()); }
  double bank() const { return attitude().bankRad * kDegrees; }
  double pitch() const { return attitude().pitchRad * kDegrees; }
  double height() const { return airplane.body().position().y; }
  double speed() const { return glm::length(airplane.body().velocity()); }
  Airflow flow() const { return airflowOf(airplane.settings(), glm::dvec3(0), airplane.body().state()); }
  // Compass direction of the flight path, degrees.
  double track() const {
    const glm::dvec3& v = airplane.body().velocity();
    return std::atan2(v.x, -v.z) * kDegrees;
  }
};

TEST(Airplane, handsOffItCruisesLevelAtSeventyMetresPerSecond) {
  // A minute without a key: height within 1 cm, speed within 1 mm/s, course within rounding.
  Flight flight;
  flight.fly(60, {});
  EXPECT_NEAR(flight.height(), 1000, 0.01);
  EXPECT_NEAR(flight.speed(), 70, 0.001);
  EXPECT_NEAR(flight.airplane.body().position().x, 0, 1e-9);
  EXPECT_NEAR(flight.flow().loadFactor, 1, 1e-6);
}

TEST(Airplane, fullThrustTopsAtOneHundredAndTwentyAndReleasedItReturnsToCruise) {
  // W for two minutes: 120 m/s within .1; released for two minutes: 70 within .5. Level all the time.
  Flight flight;
  flight.fly(120, {.thrust = 1});
  EXPECT_EQ(flight.airplane.throttle(), 1);
  EXPECT_NEAR(flight.speed(), 120, 0.1);
  flight.fly(120, {});
  EXPECT_NEAR(flight.airplane.throttle(), cruiseThrottle({}), 1e-12);
  EXPECT_NEAR(flight.speed(), 70, 0.5);
  EXPECT_NEAR(flight.height(), 1000, 1);
}

TEST(Airplane, throttleTakesASecondAndNotAStep) {
  // W moves the throttle at .7 of its travel a second: from cruise (.35) to full in .92 s; S to idle in .51
  // s.
  Flight flight;
  flight.fly(0.5, {.thrust = 1});
  EXPECT_NEAR(flight.airplane.throttle(), cruiseThrottle({}) + 0.35, 0.01);
  flight.fly(0.5, {.thrust = 1});
  EXPECT_EQ(flight.airplane.throttle(), 1);
  flight.fly(1.5, {.brake = 1});
  EXPECT_EQ(flight.airplane.throttle(), 0);
}

TEST(Airplane, aRollKeyBanksFortyFiveDegreesInAboutASecondAndAHalf) {
  // D held: 45 degrees of right bank between 1 and 2 s after the press; A does the same to the left.
  for (const double side : {1.0, -1.0}) {
    Flight flight;
    double reached = 0;
    flight.fly(3, {.roll = side}, [&] {
      if (flight.bank() * side < 45) reached += 1.0 / 120;
    });
    EXPECT_GT(reached, 1) << side;
    EXPECT_LT(reached, 2) << side;
  }
}

TEST(Airplane, handsOffItRightsItselfFromABankWithoutSwingingOver) {
  // From 50 degrees of bank: under 10 degrees 5 s after the release, under 1 after 12, never past level by
  // more than half a degree.
  Flight flight;
  flight.fly(1.5, {.roll = 1});
  EXPECT_GT(flight.bank(), 45);
  double least = 90;
  flight.fly(5, {}, [&] { least = std::min(least, flight.bank()); });
  EXPECT_LT(flight.bank(), 10);
  flight.fly(7, {}, [&] { least = std::min(least, flight.bank()); });
  EXPECT_LT(std::abs(flight.bank()), 1);
  EXPECT_GT(least, -0.5);
}

TEST(Airplane, aBankedTurnTurnsTheFlightPathAtTheRateOfPhysics) {
  // Bank held near 45 degrees for 20 s: the flight path (not only the nose) turns right at g tan(bank) / v
  // within 15 %, and nose and path stay within 3 degrees of each other.
  Flight flight;
  flight.fly(1.2, {.roll = 1});
  flight.fly(4, {.roll = 0.47});
  const double bank = flight.bank() / kDegrees, before = flight.track();
  const double expected = kGravity * std::tan(bank) / flight.speed() * kDegrees;
  flight.fly(5, {.roll = 0.47});
  EXPECT_NEAR((flight.track() - before) / 5 / expected, 1, 0.15);
  EXPECT_NEAR(flight.height(), 1000, 15);  // m in ten seconds: the trim carries it round
  EXPECT_NEAR(flight.attitude().headingRad * kDegrees, flight.track(), 3);
}

TEST(Airplane, pullingInABankTurnsTighterThanTheBankAlone) {
  // A right turn with the elevator held reverses the course within 12 s; the bank alone needs more than 20.
  const auto secondsToReverse = [](double pull) {
    Flight flight;
    flight.fly(1.5, {.roll = 1});
    double seconds = 1.5;
    while (flight.airplane.body().velocity().z < 0 && seconds < 60) {  // until it flies south
      flight.fly(0.1, {.pitch = pull, .roll = 0.5});
      seconds += 0.1;
    }
    return seconds;
  };
  EXPECT_LT(secondsToReverse(1), 6);
  EXPECT_GT(secondsToReverse(0), 10);
}

TEST(Airplane, aFullPullIsFourGsAndAHundredAndFiftyMetresOfRadius) {
  // Down arrow from cruise: the load peaks between 3 and 5.5 g, the tightest radius lies between 100 and 300
  // m, and it does not stall.
  Flight flight;
  double most = 0, tightest = 1e9;
  glm::dvec3 before = flight.airplane.body().velocity();
  flight.fly(2, {.pitch = 1}, [&] {
    const glm::dvec3 now = flight.airplane.body().velocity();
    const double turn = glm::length(glm::cross(before, now)) / (glm::length(before) * glm::length(now));
    tightest = std::min(tightest, glm::length(now) / 120 / std::max(turn, 1e-9));
    before = now;
    most = std::max(most, flight.flow().loadFactor);
    EXPECT_FALSE(flight.flow().stalled);
  });
  EXPECT_GT(most, 3);
  EXPECT_LT(most, 5.5);
  EXPECT_GT(tightest, 100);
  EXPECT_LT(tightest, 300);
}

TEST(Airplane, heldUpItClimbsSteadilyAndReleasedItLevelsOff) {
  // The elevator's effect fades with the sine of the pitch, so a held key ends in a steady climb between 25
  // and 55 degrees, up and down alike; 8 s after the release the path is within 5 degrees of level.
  for (const double way : {1.0, -1.0}) {
    Flight flight(90);
    flight.fly(4, {.thrust = 1, .pitch = way});
    EXPECT_GT(flight.pitch() * way, 25);
    EXPECT_LT(flight.pitch() * way, 55);
    flight.fly(8, {});
    EXPECT_NEAR(flight.pitch(), 0, 5);
  }
}

TEST(Airplane, theRudderSkidsAndTheFinBringsTheNoseBack) {
  // E held for 3 s: between 5 and 20 degrees of sideslip and a slow turn of the path to the right; 2 s after
  // the release the slip is gone.
  Flight flight;
  flight.fly(3, {.yaw = 1});
  EXPECT_GT(-flight.flow().sideslip * kDegrees, 5);  // the path lies left of the nose
  EXPECT_LT(-flight.flow().sideslip * kDegrees, 20);
  EXPECT_GT(flight.track(), 5);
  flight.fly(2, {});
  EXPECT_NEAR(flight.flow().sideslip * kDegrees, 0, 0.5);
}

TEST(Airplane, slowFlightSinksMildlyInsteadOfDropping) {
  // S held for a minute: it slows to a stall below 35 m/s, sinks at less than 8 m/s, wings level, and S
  // released flies on at cruise within 40 s.
  Flight flight;
  flight.fly(30, {.brake = 1});
  double sink = 0;
  flight.fly(30, {.brake = 1}, [&] { sink = std::min(sink, flight.airplane.body().velocity().y); });
  EXPECT_TRUE(flight.flow().stalled);
  EXPECT_LT(flight.speed(), 35);
  EXPECT_GT(sink, -8);
  EXPECT_NEAR(flight.bank(), 0, 1e-6);
  flight.fly(40, {});
  EXPECT_NEAR(flight.speed(), 70, 5);
  EXPECT_NEAR(flight.airplane.body().velocity().y, 0, 0.5);
}

TEST(Airplane, rollingOnTheBackAndKnifeEdgeEndLevelAgain) {
  // D held all the way round: it passes knife edge and inverted flight; released on its back it rights itself
  // within 20 s.
  Flight flight;
  bool inverted = false;
  flight.fly(12, {.roll = 1}, [&] { inverted = inverted || std::abs(flight.bank()) > 170; });
  EXPECT_TRUE(inverted);
  Flight upsideDown;
  BodyState state = Flight::start(70);
  state.orientation = orientationOf({0, 0, std::numbers::pi});
  upsideDown.airplane.place(state);
  upsideDown.fly(20, {});
  EXPECT_NEAR(upsideDown.bank(), 0, 5);
}

TEST(Airplane, eachOfTheSevenNumbersDoesWhatItSays) {
  // Each of the thesis's parameters, raised by half, changes its own effect in the stated direction.
  const auto with = [](double AirplaneSettings::*field) {
    AirplaneSettings settings;
    settings.*field *= 1.5;
    return settings;
  };
  const auto bankAfter = [](const AirplaneSettings& settings, double hold, double wait) {
    Flight flight(70, settings);
    flight.fly(hold, {.roll = 1});
    flight.fly(wait, {});
    return flight.bank();
  };
  EXPECT_GT(bankAfter(with(&AirplaneSettings::rollFactor), 0.5, 0), 1.2 * bankAfter({}, 0.5, 0));
  EXPECT_GT(bankAfter(with(&AirplaneSettings::rollSpeed), 0.5, 0), 1.2 * bankAfter({}, 0.5, 0));
  EXPECT_LT(bankAfter(with(&AirplaneSettings::stabilizingRoll), 0.5, 3), 0.8 * bankAfter({}, 0.5, 3));

  const auto pitchAfterPull = [](const AirplaneSettings& settings) {
    Flight flight(70, settings);
    flight.fly(0.3, {.pitch = 1});
    return flight.pitch();
  };
  EXPECT_GT(pitchAfterPull(with(&AirplaneSettings::pitchSpeed)), 1.2 * pitchAfterPull({}));

  const auto slipUnderRudder = [](const AirplaneSettings& settings) {
    Flight flight(70, settings);
    flight.fly(2, {.yaw = 1});
    return -flight.flow().sideslip;
  };
  EXPECT_GT(slipUnderRudder(with(&AirplaneSettings::yawSpeed)), 1.2 * slipUnderRudder({}));

  Flight faster(70, with(&AirplaneSettings::maxThrottle));
  faster.fly(100, {.thrust = 1});
  EXPECT_NEAR(faster.speed(), 120 * std::sqrt(1.5), 1);  // drag grows with the square of the speed

  const auto yawInABank = [](const AirplaneSettings& settings) {
    BodyState banked = Flight::start(70);
    banked.orientation = orientationOf({0, 0, 0.5});
    const Airplane airplane(settings, banked);
    return -airplaneWrench(settings, airplane.body().properties(), {}, 0, glm::dvec3(0), banked).torque.y;
  };
  EXPECT_GT(yawInABank(with(&AirplaneSettings::inducedYawFactor)), yawInABank({}));
}

TEST(Airplane, torquesFollowTheThesisTermByTerm) {
  // Equations 3.8 to 3.14 on an inertia of 3: the change of angular acceleration with each input and each
  // factor, to rounding (1e-12 rad/s^2).
  const auto acceleration = [](const AirplaneSettings& s, const AirplaneInput& input,
                               const Attitude& attitude) {
    BodyState state = Flight::start(70);
    state.orientation = orientationOf(attitude);
    state.velocity = state.orientation * glm::dvec3(0, 0, -70);
    const Airplane airplane(s, state);
    const MassProperties& body = airplane.body().properties();
    return body.inverseInertia * airplaneWrench(s, body, input, 0.3, glm::dvec3(0), state).torque;
  };
  const Attitude level{}, climbing{0, 0.5, 0}, banked{0, 0, 0.4};
  const auto ofInput = [&](const AirplaneInput& input, const Attitude& at) {
    return acceleration({}, input, at) - acceleration({}, {}, at);
  };
  EXPECT_NEAR(ofInput({.pitch = 1}, level).x, 20 / 3.0, 1e-12);                           // (3.8)
  EXPECT_NEAR(ofInput({.pitch = 1}, climbing).x, 20 / 3.0 * (1 - std::sin(0.5)), 1e-12);  // (3.8)
  EXPECT_NEAR(ofInput({.roll = 1}, level).z, -0.75 * 32.175 / 3, 1e-12);                  // (3.9)
  EXPECT_NEAR(ofInput({.yaw = 1}, level).y, -32.175 / 3, 1e-12);                          // (3.10)
  const auto ofFactor = [&](double AirplaneSettings::*factor, const Attitude& at) {
    AirplaneSettings without;
    without.*factor = 0;
    return acceleration({}, {}, at) - acceleration(without, {}, at);
  };
  const double sine = std::sin(0.4);
  EXPECT_NEAR(ofFactor(&AirplaneSettings::stabilizingRoll, banked).z, 0.5 * 32.175 / 3 * sine,
              1e-12);  // (3.11)
  EXPECT_NEAR(ofFactor(&AirplaneSettings::stabilizingPitch, climbing).x,
              -0.65 * 20 / 3 * std::sin(0.5) * std::cos(0.5), 1e-12);  // (3.12)
  EXPECT_NEAR(ofFactor(&AirplaneSettings::inducedYawFactor, banked).y, -0.055 * 32.175 / 3 * sine,
              1e-12);                                                                              // (3.13)
  EXPECT_NEAR(ofFactor(&AirplaneSettings::inducedPitchFactor, banked).x, -0.1 / 3 * sine, 1e-12);  // (3.14)
}

TEST(Airplane, thePitchFactorNeverReversesTheElevator) {
  // 1 - |sine of pitch| lies in [0, 1] at every attitude: a nose-up key never pushes the nose down.
  const AirplaneSettings s;
  const Airplane airplane(s, Flight::start(70));
  for (double pitch = -1.57; pitch <= 1.571; pitch += 0.01) {
    BodyState state = Flight::start(70);
    state.orientation = orientationOf({1, pitch, 2});
    const auto torque = [&](double stick) {
      return airplaneWrench(s, airplane.body().properties(), {.pitch = stick}, 0.3, glm::dvec3(0), state)
          .torque.x;
    };
    const double full = airplane.body().properties().inertia[0][0] * 20 / 3;
    EXPECT_GE(torque(1) - torque(0), -1e-9 * full);
    EXPECT_LE(torque(1) - torque(0), full * (1 + 1e-9));
  }
}

TEST(Airplane, windCarriesTheWholeFlightAlong) {
  // In air that moves with 12 m/s to the east a flight is the calm one shifted by the wind: within 1e-6 m
  // after 10 s.
  Flight calm;
  Airplane windy({}, [] {
    BodyState state = Flight::start(70);
    state.velocity.x += 12;
    return state;
  }());
  for (int i = 0; i < 1200; ++i) {
    const AirplaneInput input{.pitch = i > 300 && i < 500 ? 1.0 : 0.0, .roll = i < 200 ? 1.0 : 0.0};
    calm.airplane.step(input, glm::dvec3(0), 1.0 / 120);
    windy.step(input, {12, 0, 0}, 1.0 / 120);
  }
  const glm::dvec3 shifted = windy.body().position() - glm::dvec3(120, 0, 0);
  EXPECT_LT(glm::length(shifted - calm.airplane.body().position()), 1e-6);
}

}  // namespace
}  // namespace skydrop::flight
