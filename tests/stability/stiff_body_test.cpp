// Bodies whose forces are too stiff for a step: dampers, drags, springs, contacts and friction.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <string>
#include <utility>

#include "skydrop/core/guards.h"
#include "skydrop/core/hash.h"
#include "skydrop/flight/airplane.h"
#include "skydrop/flight/rigid_body.h"
#include "support/margin.h"

namespace skydrop::flight {
namespace {

constexpr std::array kIntegrators = {Integrator::thesis, Integrator::semiImplicitEuler, Integrator::rk4,
                                     Integrator::rkmk4};

std::string nameOf(Integrator integrator) {
  return std::string(kIntegratorNames[static_cast<std::size_t>(integrator)]);
}

glm::dmat3 diagonal(const glm::dvec3& d) { return {d.x, 0, 0, 0, d.y, 0, 0, 0, d.z}; }

bool isFinite(const BodyState& s) {
  return core::isFinite(s.position) && core::isFinite(s.velocity) && core::isFinite(s.angularVelocity) &&
         std::abs(glm::length(s.orientation) - 1) < 1e-9;
}

double rotationalEnergy(const RigidBody& body) {
  const glm::dvec3& spin = body.state().angularVelocity;
  return 0.5 * glm::dot(spin, body.properties().inertia * spin);
}

// The brick of NASA's check case 3 (Murri, Jackson, Shelton, NASA/TM-2015-218675) in SI: mass kg, inertia kg
// m^2, lengths that its damping coefficients of -1 refer to.
constexpr double kBrickMass = 2.26796, kBrickArea = 0.0206451, kBrickSpan = 0.1016, kBrickChord = 0.2032;
constexpr glm::dvec3 kBrickInertia{0.00256821, 0.00842102, 0.00975468};

RigidBody brick(Integrator integrator) {
  RigidBody body(kBrickMass, glm::dvec3(0), glm::dquat(1, 0, 0, 0), diagonal(kBrickInertia));
  BodyState start;
  start.angularVelocity = {0.174533, 0.349066, 0.523599};  // 10, 20, 30 degrees a second
  start.position = {0, 9144, 0};
  body.setState(start);
  body.setIntegrator(integrator);
  return body;
}

// Damping torque at an airspeed, `times` that of the check case.
glm::dvec3 brickDamping(double times, double density, double speed, const glm::dvec3& spin) {
  const glm::dvec3 lengths{kBrickSpan, kBrickChord, kBrickSpan};
  return -times * 0.25 * density * speed * kBrickArea * lengths * lengths * spin;
}

TEST(Stability, P24_theBrickOfTheCheckCaseUnderAHundredTimesItsDampingComesToRest) {
  // 100 times the damping at 60 Hz, 1000 times at 120 Hz, 1e6 times at 8 Hz, at the speed it has after 30 s:
  // no step adds energy, after a second it is at rest, and the steps are counted. Undivided it grows to 1e50.
  for (const Integrator integrator : kIntegrators) {
    for (const auto& [times, rate] : {std::pair(1e2, 60), std::pair(1e3, 120), std::pair(1e6, 8)}) {
      const std::string what = nameOf(integrator) + " " + std::to_string(times);
      core::resetGuardCounts();
      RigidBody body = brick(integrator);
      const double start = rotationalEnergy(body);
      double last = start;
      for (int i = 0; i < 5 * rate; ++i) {
        body.update(1.0 / rate, [times = times](const BodyState& s) {
          return Wrench{glm::dvec3(0), brickDamping(times, 0.7, 294, s.angularVelocity)};
        });
        const double now = rotationalEnergy(body);
        ASSERT_LE(now, last * (1 + 1e-12)) << what << " step " << i;
        last = now;
      }
      EXPECT_TRUE(test::holds("P24", last, test::below(1e-12 * start), "J")) << what;
      EXPECT_GT(core::guardCount(core::Guard::stiffStep), 0u) << what;
      EXPECT_EQ(core::guardCount(core::Guard::notFiniteState), 0u) << what;
    }
  }
}

TEST(Stability, P24_theFallingBrickStaysAtRestWhenItsDampingGrowsStiff) {
  // Dropped from 9144 m the damping grows with the speed: by the time it is stiff the spin has died down, and
  // nothing makes it grow out of rounding. Beyond 1e-9 rad/s it never comes back.
  for (const Integrator integrator : kIntegrators) {
    for (const auto& [times, rate] : {std::pair(1e2, 60), std::pair(1e3, 120)}) {
      RigidBody body = brick(integrator);
      for (int i = 0; i < 30 * rate; ++i) {
        body.update(1.0 / rate, [times = times](const BodyState& s) {
          const double density = 1.225 * std::exp(-s.position.y / 9000);
          return Wrench{{0, -kBrickMass * 9.80665, 0},
                        brickDamping(times, density, glm::length(s.velocity), s.angularVelocity)};
        });
        if (i > 10 * rate) {
          ASSERT_TRUE(
              test::holds("P24", glm::length(body.state().angularVelocity), test::below(1e-9), "rad/s"))
              << nameOf(integrator) << " step " << i;
        }
      }
      EXPECT_TRUE(
          test::holds("P24", test::apart(body.velocity().y, -9.80665 * 30), test::atMost(1e-6), "m/s"))
          << nameOf(integrator);
    }
  }
}

struct Random {
  core::RandomStream stream;
  double between(double from, double to) { return from + (to - from) * stream.nextUnit(); }
  double decades(double from, double to) { return std::pow(10, between(from, to)); }
  glm::dvec3 vector(double most) {
    return {between(-most, most), between(-most, most), between(-most, most)};
  }
};

// A body with a right-hand side, and what may not grow.
struct Stiff {
  double stiffness = 0;  // 1/s; 0 where it has none
  RigidBody body;
  std::function<Wrench(const BodyState&)> wrench;
  std::function<double(const RigidBody&)> energy;
};

// A body of any size and shape (a physical one: no moment of inertia above the sum of the others).
RigidBody anyBody(Random& random) {
  const double a = random.decades(-2, 3), b = a * random.decades(0, 1);
  const double c = random.between(b - a + 0.01 * a, b + 0.99 * a);
  RigidBody body(random.decades(-1, 3), glm::dvec3(0), glm::dquat(1, 0, 0, 0), diagonal({a, b, c}));
  BodyState start;
  start.position = random.vector(5);
  start.velocity = random.vector(50);
  start.angularVelocity = random.vector(3);
  body.setState(start);
  return body;
}

// Flies `bodies` bodies of this kind for 40 steps with every integrator at 8 to 240 Hz. Every state is
// finite, nothing is refused, no step adds more than `growth` of its energy, and where a rate is five times
// what a step takes it was counted.
void expectDecay(const std::function<Stiff(Random&)>& make, int bodies, double growth) {
  for (const Integrator integrator : kIntegrators) {
    Random random{{11, static_cast<std::uint64_t>(integrator)}};
    for (int n = 0; n < bodies; ++n) {
      constexpr std::array rates = {8, 15, 30, 60, 120, 240};
      const double rate = rates[static_cast<std::size_t>(random.between(0, 5.999))];
      Stiff stiff = make(random);
      stiff.body.setIntegrator(integrator);
      core::resetGuardCounts();
      const double start = stiff.energy(stiff.body);
      double last = start;
      for (int i = 0; i < 40; ++i) {
        stiff.body.update(1 / rate, stiff.wrench);
        ASSERT_TRUE(isFinite(stiff.body.state())) << nameOf(integrator) << " body " << n;
        const double now = stiff.energy(stiff.body);
        ASSERT_LE(now, last * (1 + growth) + 1e-14 * start)
            << nameOf(integrator) << " body " << n << " step " << i << " at " << rate << " Hz, stiffness "
            << stiff.stiffness;
        last = now;
      }
      EXPECT_LT(last, start) << nameOf(integrator) << " body " << n;
      EXPECT_EQ(core::guardCount(core::Guard::notFiniteState), 0u) << nameOf(integrator) << " body " << n;
      if (stiff.stiffness / rate > 5 * wholeStepBound(integrator)) {
        EXPECT_GT(core::guardCount(core::Guard::stiffStep), 0u)
            << nameOf(integrator) << " body " << n << " at " << rate << " Hz, stiffness " << stiff.stiffness;
      }
    }
  }
}

TEST(Stability, P24_dampersAndDragsOfAnyStrengthOnlyTakeEnergy) {
  // Rates over 12 orders of magnitude, linear, quadratic and cubic in the velocity, for translation and
  // rotation of bodies of any shape, in still air.
  test::noFaults("P24", "violations");
  expectDecay(
      [](Random& random) {
        RigidBody body = anyBody(random);
        const double k = random.decades(-3, 9), exponent = std::floor(random.between(0, 3));
        const glm::dvec3 v = body.velocity(), w = body.state().angularVelocity;
        const double linear = k / std::pow(glm::length(v), exponent),
                     angular = k / std::pow(glm::length(w), exponent);
        const double mass = body.mass(), least = body.properties().inertia[0][0];
        return Stiff{
            k, body,
            [=](const BodyState& s) {
              const double speed = std::pow(glm::length(s.velocity), exponent),
                           spin = std::pow(glm::length(s.angularVelocity), exponent);
              return Wrench{-mass * linear * speed * s.velocity, -least * angular * spin * s.angularVelocity};
            },
            [](const RigidBody& b) { return b.kineticEnergy(); }};
      },
      60, 1e-9);
}

TEST(Stability, P24_aStiffDragTakesABodyAlongWithTheWind) {
  // Drag towards air that moves: it is the velocity through the air that dies away.
  test::noFaults("P24", "violations");
  const glm::dvec3 wind{30, 5, -10};
  expectDecay(
      [=](Random& random) {
        RigidBody body = anyBody(random);
        const double k = random.decades(-3, 9), mass = body.mass();
        return Stiff{k, body,
                     [=](const BodyState& s) {
                       return Wrench{-mass * k * (s.velocity - wind), glm::dvec3(0)};
                     },
                     [=](const RigidBody& b) {
                       const glm::dvec3 through = b.velocity() - wind;
                       return glm::dot(through, through);
                     }};
      },
      40, 1e-9);
}

TEST(Stability, P24_dampedSpringsOfAnyStiffnessComeToRest) {
  // Springs of position over 12 orders of magnitude, with damping ratios of .3 to 10. What a whole step makes
  // of the energy depends on its phase, so that single steps may add a tenth; where steps are divided it
  // falls.
  test::noFaults("P24", "violations");
  expectDecay(
      [](Random& random) {
        RigidBody body = anyBody(random);
        const double k = random.decades(-3, 9), ratio = random.decades(-0.5, 1), mass = body.mass();
        const double w = std::sqrt(k);
        return Stiff{
            w * std::max(ratio, 1.0), body,
            [=](const BodyState& s) {
              return Wrench{-mass * (k * s.position + 2 * ratio * w * s.velocity), glm::dvec3(0)};
            },
            [=](const RigidBody& b) {
              return 0.5 * mass *
                     (glm::dot(b.velocity(), b.velocity()) + k * glm::dot(b.position(), b.position()));
            }};
      },
      60, 0.1);
}

TEST(Stability, P24_dryFrictionOfAnyStrengthStopsABody) {
  // A force against the velocity of constant size, with a corner at rest that no linearisation sees from
  // afar.
  test::noFaults("P24", "violations");
  expectDecay(
      [](Random& random) {
        RigidBody body = anyBody(random);
        const double k = random.decades(2, 9), mass = body.mass();
        return Stiff{
            0, body,
            [=](const BodyState& s) {
              return Wrench{-mass * k / (glm::length(s.velocity) + 1e-3) * s.velocity, glm::dvec3(0)};
            },
            [](const RigidBody& b) { return glm::dot(b.velocity(), b.velocity()); }};
      },
      40, 1e-9);
}

TEST(Stability, P24_aStiffFloorDoesNotThrowABodyUp) {
  // A wall that pushes back like a spring from where it is touched: a body that falls on it through 10 m at 8
  // to 240 Hz never rises more than a metre above where it started. (The integrators of one stage see a force
  // that begins within a step when it has acted: not promised.)
  test::noFaults("P24", "violations");
  for (const Integrator integrator : {Integrator::rk4, Integrator::rkmk4}) {
    Random random{{12, static_cast<std::uint64_t>(integrator)}};
    for (int n = 0; n < 40; ++n) {
      constexpr std::array rates = {8, 15, 30, 60, 120, 240};
      const double rate = rates[static_cast<std::size_t>(random.between(0, 5.999))];
      const double k = rate * rate * random.decades(1.5, 9);  // in a step more than 5 rad of its oscillation
      RigidBody body(1, {0, random.between(9, 11), 0}, glm::dquat(1, 0, 0, 0), glm::dmat3(1));
      body.setIntegrator(integrator);
      const double start = body.position().y;
      for (int i = 0; i < 6 * rate; ++i) {
        body.update(1 / rate, [=](const BodyState& s) {
          return Wrench{{0, (s.position.y < 0 ? -k * s.position.y : 0) - 9.80665, 0}, glm::dvec3(0)};
        });
        ASSERT_LT(body.position().y, start + 1)
            << nameOf(integrator) << " body " << n << " step " << i << " at " << rate << " Hz, k " << k;
      }
    }
  }
}

TEST(Stability, P24_aFastSpinOfAnUnevenBodyIsDividedAndKeepsItsEnergy) {
  // The gyroscopic term alone is stiff at 300 rad/s and 60 Hz: the Runge-Kutta integrators follow it in
  // parts, within 2 % of the energy after a second, where whole steps end in NaN.
  for (const Integrator integrator : {Integrator::rk4, Integrator::rkmk4}) {
    core::resetGuardCounts();
    RigidBody body(1, glm::dvec3(0), glm::dquat(1, 0, 0, 0), diagonal({10, 20, 26}));
    BodyState start;
    start.angularVelocity = {20, 300, 20};
    body.setState(start);
    body.setIntegrator(integrator);
    const double energy = body.kineticEnergy();
    for (int i = 0; i < 60; ++i) body.update(1.0 / 60);
    EXPECT_TRUE(
        test::holds("P24", test::apart(body.kineticEnergy() / energy, 1), test::atMost(0.02), "relative"))
        << nameOf(integrator);
    EXPECT_GT(core::guardCount(core::Guard::stiffStep), 0u) << nameOf(integrator);
  }
}

TEST(Stability, P24_aDividedStepFollowsADecayThatItCanResolve) {
  // A decay of 10 to 60 in a step: after a step the Runge-Kutta integrators have what is left of a slow one
  // beside it (1/s) within 1e-8, and of the stiff one no more than a twentieth.
  for (const Integrator integrator : {Integrator::rk4, Integrator::rkmk4}) {
    for (const double inAStep : {10.0, 30.0, 60.0}) {
      RigidBody body(1, glm::dvec3(0), glm::dquat(1, 0, 0, 0), glm::dmat3(1));
      BodyState start;
      start.velocity = {1, 1, 0};
      body.setState(start);
      body.setIntegrator(integrator);
      const double stiff = inAStep * 120;
      body.update(1.0 / 120, [=](const BodyState& s) {
        return Wrench{{-stiff * s.velocity.x, -s.velocity.y, 0}, glm::dvec3(0)};
      });
      EXPECT_TRUE(test::holds("P24", std::abs(body.velocity().x), test::below(0.05), "m/s")) << inAStep;
      EXPECT_TRUE(
          test::holds("P24", test::apart(body.velocity().y, std::exp(-1.0 / 120)), test::atMost(1e-8), "m/s"))
          << inAStep;
    }
  }
}

TEST(Stability, P24_nothingOfTheAircraftIsStiff) {
  // A minute of hard flying at 120 Hz with every integrator divides no step: the guard costs no accuracy
  // there.
  test::noFaults("P24", "violations");
  for (const Integrator integrator : kIntegrators) {
    AirplaneSettings settings;
    settings.integrator = integrator;
    BodyState start;
    start.position = {0, 2000, 0};
    start.velocity = {0, 0, -70};
    Airplane airplane(settings, start);
    core::resetGuardCounts();
    core::RandomStream random{5, 0};
    AirplaneInput input;
    for (int i = 0; i < 60 * 120; ++i) {
      if (i % 60 == 0) {
        const auto stick = [&] { return std::floor(random.nextUnit() * 3) - 1; };
        input = {.thrust = random.nextUnit(), .pitch = stick(), .roll = stick(), .yaw = stick()};
      }
      airplane.step(input, glm::dvec3(0), 1.0 / 120);
    }
    EXPECT_EQ(core::guardCount(core::Guard::stiffStep), 0u) << nameOf(integrator);
  }
}

TEST(Stability, P24_anAircraftTunedFarTooStiffStaysInTheAir) {
  // Stiffness and damping a hundred times what they are, at 120 Hz: the flight stays finite and its rates
  // small, and the steps are counted.
  for (const Integrator integrator : kIntegrators) {
    AirplaneSettings settings;
    settings.integrator = integrator;
    settings.pitchStiffness *= 100, settings.yawStiffness *= 100;
    settings.rollDamping *= 100, settings.pitchDamping *= 100, settings.yawDamping *= 100;
    BodyState start;
    start.velocity = {0, 0, -70};
    Airplane airplane(settings, start);
    core::resetGuardCounts();
    for (int i = 0; i < 5 * 120; ++i) {
      airplane.step({.pitch = i < 120 ? 1.0 : 0.0, .roll = i < 240 ? 1.0 : -1.0}, glm::dvec3(0), 1.0 / 120);
      ASSERT_TRUE(isFinite(airplane.body().state())) << nameOf(integrator) << " step " << i;
      ASSERT_TRUE(
          test::holds("P24", glm::length(airplane.body().state().angularVelocity), test::below(3), "rad/s"))
          << nameOf(integrator) << " step " << i;
    }
    EXPECT_GT(core::guardCount(core::Guard::stiffStep), 0u) << nameOf(integrator);
  }
}

// Error after .7 s (no whole period, over which errors cancel) of a body that is pushed and turned by cos(2
// pi t): of its position in m, and of its attitude in rad.
glm::dvec2 errorsUnderAForceOfTime(Integrator integrator, int rate) {
  RigidBody body(1, glm::dvec3(0), glm::dquat(1, 0, 0, 0), glm::dmat3(1));
  body.setIntegrator(integrator);
  const double w = 2 * 3.14159265358979323846;
  const int steps = 7 * rate / 10;
  for (int i = 0; i < steps; ++i) {
    body.update(
        1.0 / rate,
        [=](const BodyState&, double time) {
          return Wrench{{std::cos(w * time), 0, 0}, {std::cos(w * time), 0, 0}};
        },
        static_cast<double>(i) / rate);
  }
  const double truth = (1 - std::cos(w * 0.7)) / (w * w);
  const glm::dquat& q = body.orientation();
  return {std::abs(body.position().x - truth), std::abs(2 * std::atan2(q.x, q.w) - truth)};
}

TEST(Stability, P25_aForceOfTimeKeepsTheOrderOfTheIntegrator) {
  // A right-hand side gets the time of each stage: between 60 and 240 Hz the errors fall by the declared
  // order within .2, and with the default at 120 Hz they are below 1e-8 (m, rad). By the time of the step
  // they are 6 mm.
  for (const Integrator integrator : kIntegrators) {
    const glm::dvec2 at60 = errorsUnderAForceOfTime(integrator, 60),
                     at240 = errorsUnderAForceOfTime(integrator, 240);
    for (int part = 0; part < 2; ++part) {
      const double order = std::log(at60[part] / at240[part]) / std::log(4);
      EXPECT_TRUE(
          test::holds("P25", test::apart(order, declaredOrder(integrator)), test::atMost(0.2), "order"))
          << nameOf(integrator) << " part " << part;
    }
  }
  const glm::dvec2 shipped = errorsUnderAForceOfTime(Integrator::rk4, 120);
  EXPECT_TRUE(test::holds("P25", std::max(shipped.x, shipped.y), test::below(1e-8), "m"));
}

TEST(Stability, P25_aDividedStepPassesTheTimeOfItsParts) {
  // A stiff drag towards air whose speed grows with the time: the body keeps up with it, behind by the
  // acceleration of the air over the rate (a = 2 m/s^2, k = 5000 and 1e6 1/s) within a millimetre a second.
  for (const Integrator integrator : kIntegrators) {
    for (const double k : {5e3, 1e6}) {
      RigidBody body(3, glm::dvec3(0), glm::dquat(1, 0, 0, 0), glm::dmat3(1));
      body.setIntegrator(integrator);
      for (int i = 0; i < 240; ++i) {
        body.update(
            1.0 / 120,
            [=](const BodyState& s, double time) {
              return Wrench{-3.0 * k * (s.velocity - glm::dvec3(2 * time, 0, 0)), glm::dvec3(0)};
            },
            i / 120.0);
      }
      EXPECT_TRUE(
          test::holds("P25", test::apart(body.velocity().x, 2 * 2.0 - 2 / k), test::atMost(1e-3), "m/s"))
          << nameOf(integrator) << " " << k;
    }
  }
}

}  // namespace
}  // namespace skydrop::flight
