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
  Airflow flow() const {
    return airflowOf(airplane.settings(), airplane.separation(), glm::dvec3(0), airplane.body().state());
  }
  bool stallAnnounced() const { return flow().stallShare >= airplane.settings().stallWarning; }
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
  // Down arrow from cruise, full deflection after .4 s: the load passes 2 g not before .3 s and peaks between
  // 3 and 5 g after .7 to 1.2 s, the tightest radius lies between 100 and 300 m, and no stall is announced.
  Flight flight;
  double most = 0, tightest = 1e9, now = 0, peakAt = 0, twoAt = 0;
  glm::dvec3 before = flight.airplane.body().velocity();
  while (now < 2) {
    now += 1.0 / 120;
    flight.fly(1.0 / 120, {.pitch = std::min(now / 0.4, 1.0)});
    const glm::dvec3 velocity = flight.airplane.body().velocity();
    const double turn =
        glm::length(glm::cross(before, velocity)) / (glm::length(before) * glm::length(velocity));
    tightest = std::min(tightest, glm::length(velocity) / 120 / std::max(turn, 1e-9));
    before = velocity;
    const double load = flight.flow().loadFactor;
    if (twoAt == 0 && load > 2) twoAt = now;
    if (load > most) most = load, peakAt = now;
    EXPECT_FALSE(flight.stallAnnounced());
  }
  EXPECT_GT(twoAt, 0.3);
  EXPECT_GT(most, 3);
  EXPECT_LT(most, 5);
  EXPECT_GT(peakAt, 0.7);
  EXPECT_LT(peakAt, 1.2);
  EXPECT_GT(tightest, 100);
  EXPECT_LT(tightest, 300);
}

TEST(Airplane, heldUpItClimbsAndReleasedItLevelsOff) {
  // Two and a half seconds of full elevator end between 25 and 55 degrees, up and down alike; 8 s after the
  // release the path is within 5 degrees of level.
  for (const double way : {1.0, -1.0}) {
    Flight flight(90);
    flight.fly(2.5, {.thrust = 1, .pitch = way});
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

TEST(Airplane, withoutThrustItGlidesAndTheStallIsAnnouncedButDoesNotCome) {
  // S held for two minutes, hands off the stick: it slows, the warning comes, the nose settles a little low
  // and it glides at 30 to 35 m/s, sinking at 3 to 5, wings level, the flow attached all the time. Released
  // it is back at cruise within 40 s.
  Flight flight;
  flight.fly(120, {.brake = 1}, [&] { EXPECT_LT(flight.airplane.separation(), 0.1); });
  EXPECT_TRUE(flight.stallAnnounced());
  EXPECT_NEAR(flight.speed(), 32.5, 2.5);
  EXPECT_NEAR(flight.airplane.body().velocity().y, -4, 1);
  EXPECT_NEAR(flight.pitch(), -5.5, 2);
  EXPECT_NEAR(flight.bank(), 0, 1e-6);
  flight.fly(40, {});
  EXPECT_NEAR(flight.speed(), 70, 5);
  EXPECT_NEAR(flight.airplane.body().velocity().y, 0, 0.5);
}

// Slows to 40 m/s at idle, then pulls until the flow has left the wing.
struct Stall {
  Flight flight;
  double announcedAt = -1, stalledAt = -1, speed = 0, top = 0;

  explicit Stall(double pull) {
    while (flight.speed() > 40) flight.fly(0.1, {.brake = 1});
    double now = 0;
    while (stalledAt < 0 && now < 30) {
      flight.fly(1.0 / 120, {.brake = 1, .pitch = pull * std::min(now / 0.4, 1.0)});
      now += 1.0 / 120;
      if (announcedAt < 0 && flight.stallAnnounced()) announcedAt = now;
      if (flight.airplane.separation() >= kStalledSeparation) stalledAt = now;
      top = std::max(top, flight.height());
    }
    speed = flight.speed();
  }
};

TEST(Airplane, aStallIsAnnouncedSecondsAheadAndComesBelowThirtyMetresPerSecond) {
  // From 40 m/s at idle, half and three quarters of the stick pulled: at least 3 s from the warning to the
  // stall, which comes between 24 and 31 m/s.
  for (const double pull : {0.5, 0.75}) {
    const Stall stall(pull);
    ASSERT_GT(stall.stalledAt, 0) << pull;
    EXPECT_GT(stall.announcedAt, 0) << pull;
    EXPECT_GT(stall.stalledAt - stall.announcedAt, 3) << pull;
    EXPECT_GT(stall.speed, 24) << pull;
    EXPECT_LT(stall.speed, 31) << pull;
  }
}

TEST(Airplane, aStallDropsTheNoseAndIsOverSoonAfterTheStickIsLetGo) {
  // The nose falls below -15 degrees and less than .7 of the weight is carried, although the stick is still
  // pulled for a second. Let go, also at idle, the flow is back within 3 s and no more than 120 m are lost.
  for (const double pull : {0.5, 0.75}) {
    Stall stall(pull);
    Flight& flight = stall.flight;
    double lowestNose = 90, least = 9, lowest = 1e9, attachedAfter = 0;
    const auto watch = [&] {
      lowestNose = std::min(lowestNose, flight.pitch());
      least = std::min(least, flight.flow().loadFactor);
      lowest = std::min(lowest, flight.height());
    };
    flight.fly(1, {.brake = 1, .pitch = pull}, watch);
    flight.fly(20, {.brake = 1}, [&] {
      watch();
      if (flight.airplane.separation() > 0.1) attachedAfter += 1.0 / 120;
    });
    EXPECT_LT(lowestNose, -15) << pull;
    EXPECT_GT(lowestNose, -40) << pull;
    EXPECT_LT(least, 0.7) << pull;
    EXPECT_LT(attachedAfter, 3) << pull;
    // 20 s of gliding at idle lose 80 m of themselves.
    EXPECT_LT(stall.top - lowest, 120 + 80) << pull;
  }
}

TEST(Airplane, fullThrottleAndALittlePushEndAStallAtOnce) {
  // What a pilot does: stick forward a little and W for two seconds, then hands off. Within 60 m of the top
  // it climbs or flies level again.
  Stall stall(0.75);
  Flight& flight = stall.flight;
  double lowest = 1e9;
  flight.fly(2, {.thrust = 1, .pitch = -0.2}, [&] { lowest = std::min(lowest, flight.height()); });
  flight.fly(10, {.thrust = 1}, [&] { lowest = std::min(lowest, flight.height()); });
  EXPECT_LT(stall.top - lowest, 60);
  EXPECT_FALSE(flight.stallAnnounced());
  EXPECT_GT(flight.airplane.body().velocity().y, -1);
}

// Holds a bank as a pilot does who watches the horizon, with this pull.
AirplaneInput bankHeld(const Flight& flight, double bankDeg, double pull) {
  const double wanted = bankDeg / kDegrees;
  const double roll = 0.67 * std::sin(wanted) + 2.5 * (wanted - flight.bank() / kDegrees) +
                      0.3 * flight.airplane.body().state().angularVelocity.z;
  return {.pitch = pull, .roll = std::clamp(roll, -1.0, 1.0)};
}

TEST(Airplane, aTurnSinksALittleAndALittleBackPressureHoldsItsHeight) {
  // Turns of 30 and 45 degrees for 20 s. Stick back by at most a twentieth, as the sinking asks for it:
  // height within 8 m, speed within 5 m/s, turning at g tan(bank) / v within 5 %, slipping less than 1
  // degree. Without the back pressure it sinks, at less than 2 m/s.
  for (const double bank : {30.0, 45.0}) {
    for (const bool pulling : {true, false}) {
      Flight flight;
      double height = 0, off = 0, most = 0, track = 0;
      for (int i = 0; i < 28 * 120; ++i) {
        if (i == 8 * 120) height = flight.height(), track = flight.track();
        const double sink = -flight.airplane.body().velocity().y;
        const double pull = pulling ? std::clamp(0.02 * sink, 0.0, 0.05) : 0;
        flight.fly(1.0 / 120, bankHeld(flight, bank, pull));
        if (i < 8 * 120) continue;
        off = std::max(off, std::abs(flight.height() - height));
        most = std::max(most, pull);
        if (i == 10 * 120) {
          const double rate = std::remainder(flight.track() - track, 360.0) / 2;
          const double physics = kGravity * std::tan(bank / kDegrees) / flight.speed() * kDegrees;
          EXPECT_NEAR(rate / physics, 1, 0.05) << bank;
        }
      }
      EXPECT_NEAR(flight.speed(), 70, 5) << bank;
      EXPECT_LT(std::abs(flight.flow().sideslip) * kDegrees, 1) << bank;
      if (pulling) {
        EXPECT_LT(off, 8) << bank;
        EXPECT_GT(most, 0) << bank;
      } else {
        EXPECT_LT(flight.airplane.body().velocity().y, -0.3) << bank;
        EXPECT_GT(flight.airplane.body().velocity().y, -2) << bank;
      }
    }
  }
}

TEST(Airplane, speedBleedsInAClimbAndComesBackAfterIt) {
  // Nose held 10 degrees up at cruise throttle for 20 s: 12 to 25 m/s are lost and no stall is announced; let
  // go, over half of it is back 20 s later in level flight. With W the same climb is steady above 100 m/s, at
  // 15 to 22 m/s upwards.
  const auto climb = [](Flight& flight, double seconds, double thrust) {
    for (int i = 0; i < static_cast<int>(seconds * 120); ++i) {
      const double pull = std::clamp(0.08 * (10 - flight.pitch()) + 0.12, -1.0, 1.0);
      flight.fly(1.0 / 120, {.thrust = thrust, .pitch = pull});
      EXPECT_FALSE(flight.stallAnnounced());
    }
  };
  Flight flight;
  climb(flight, 20, 0);
  const double slow = flight.speed();
  EXPECT_NEAR(slow, 51.5, 6.5);
  EXPECT_GT(flight.airplane.body().velocity().y, 6);
  flight.fly(20, {});
  EXPECT_GT(flight.speed(), slow + (70 - slow) / 2);
  EXPECT_NEAR(flight.airplane.body().velocity().y, 0, 0.1);
  Flight full;
  climb(full, 60, 1);
  EXPECT_GT(full.speed(), 100);
  EXPECT_NEAR(full.airplane.body().velocity().y, 18.5, 3.5);
}

TEST(Airplane, fastEnoughItLoopsAndTheThesissLawDoesNot) {
  // At 110 m/s with W and the elevator held: it goes over the top (the nose points back, on its back) within
  // 15 s and never stalls. With pitchFade 1, equation 3.8 to the letter, it ends in a climb below 55 degrees.
  const auto overTheTop = [](double fade) {
    AirplaneSettings settings;
    settings.pitchFade = fade;
    Flight flight(110, settings);
    bool inverted = false;
    flight.fly(15, {.thrust = 1, .pitch = 1}, [&] {
      inverted = inverted || std::abs(flight.bank()) > 150;
      EXPECT_LT(flight.airplane.separation(), kStalledSeparation);
    });
    return inverted;
  };
  EXPECT_TRUE(overTheTop(AirplaneSettings().pitchFade));
  EXPECT_FALSE(overTheTop(1));
}

TEST(Airplane, handsOffItReturnsToLevelFromAnyAttitude) {
  // Every bank from level to inverted with the nose from 80 degrees down to 80 up, at 70 m/s: bank under 5
  // degrees and level path within 25 s. Only from steep dives it takes longer, up to 45. From level or above
  // at most 300 m are lost, from 40 degrees down 700.
  for (double bank = 0; bank <= 180; bank += 45) {
    for (const double pitch : {-80.0, -40.0, 0.0, 40.0, 80.0}) {
      Flight flight;
      BodyState state = Flight::start(70);
      state.orientation = orientationOf({0, pitch / kDegrees, bank / kDegrees});
      state.velocity = state.orientation * glm::dvec3(0, 0, -70);
      flight.airplane.place(state);
      double lowest = 1000;
      flight.fly(pitch < -40 ? 45 : 25, {}, [&] { lowest = std::min(lowest, flight.height()); });
      EXPECT_LT(std::abs(flight.bank()), 5) << bank << " " << pitch;
      EXPECT_LT(std::abs(flight.airplane.body().velocity().y), 2) << bank << " " << pitch;
      EXPECT_GT(lowest, pitch >= 0 ? 700 : pitch >= -40 ? 300 : -2500) << bank << " " << pitch;
    }
  }
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
    return -airplaneWrench(settings, airplane.body().properties(), {}, {}, glm::dvec3(0), banked).torque.y;
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
    return body.inverseInertia *
           airplaneWrench(s, body, input, {.throttle = 0.3}, glm::dvec3(0), state).torque;
  };
  const Attitude level{}, climbing{0, 0.5, 0}, banked{0, 0, 0.4};
  const auto ofInput = [&](const AirplaneInput& input, const Attitude& at) {
    return acceleration({}, input, at) - acceleration({}, {}, at);
  };
  EXPECT_NEAR(ofInput({.pitch = 1}, level).x, 20 / 3.0, 1e-12);                                 // (3.8)
  EXPECT_NEAR(ofInput({.pitch = 1}, climbing).x, 20 / 3.0 * (1 - 0.5 * std::sin(0.5)), 1e-12);  // (3.8)
  EXPECT_NEAR(ofInput({.roll = 1}, level).z, -0.75 * 32.175 / 3, 1e-12);                        // (3.9)
  EXPECT_NEAR(ofInput({.yaw = 1}, level).y, -32.175 / 3, 1e-12);                                // (3.10)
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
      return airplaneWrench(s, airplane.body().properties(), {.pitch = stick}, {.throttle = 0.3},
                            glm::dvec3(0), state)
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
    windy.step(input, glm::dvec3(12, 0, 0), 1.0 / 120);
  }
  const glm::dvec3 shifted = windy.body().position() - glm::dvec3(120, 0, 0);
  EXPECT_LT(glm::length(shifted - calm.airplane.body().position()), 1e-6);
}

}  // namespace
}  // namespace skydrop::flight
