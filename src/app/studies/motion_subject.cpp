#include <array>
#include <cmath>

#include "app/studies/subjects.h"
#include "app/studies/table_subject.h"
#include "skydrop/core/hash.h"
#include "skydrop/flight/airplane.h"
#include "skydrop/flight/environment.h"
#include "skydrop/flight/landing_gear.h"
#include "skydrop/flight/rotation.h"

namespace skydrop::app {
namespace {

using flight::Integrator;

enum class Body { torqueFree, projectile, flight, touchdown };
constexpr std::array<std::string_view, 4> kBodyNames = {"torqueFree", "projectile", "flight", "touchdown"};

struct MotionParameters {
  Body body = Body::torqueFree;
  Integrator integrator = flight::AirplaneSettings{}.integrator;
  std::int64_t rateHz = 120;
  double seconds = 10;
};

void describe(core::SettingsVisitor& visitor, MotionParameters& p) {
  visitor.choice("body", p.body, kBodyNames, {.help = "What moves."});
  visitor.choice("integrator", p.integrator, flight::kIntegratorNames, {.help = "How a step is taken."});
  visitor.integer("rateHz", p.rateHz, {.unit = "Hz", .min = 10, .max = 1000000, .help = "Steps a second."});
  visitor.number("seconds", p.seconds, {.unit = "s", .min = 1, .max = 60, .help = "How long it moves."});
}

// Hard case P01: torque-free, with three different moments of inertia, about its middle axis.
flight::RigidBody tumblingBody(Integrator integrator) {
  flight::RigidBody body(1, glm::dvec3(0), glm::dquat(1, 0, 0, 0), glm::dmat3(10, 0, 0, 0, 20, 0, 0, 0, 26));
  flight::BodyState state = body.state();
  state.angularVelocity = {1, 15, 1};
  body.setState(state);
  body.setIntegrator(integrator);
  return body;
}

flight::RigidBody thrownBody(Integrator integrator) {
  flight::RigidBody body(1, glm::dvec3(0, 1000, 0), glm::dquat(1, 0, 0, 0), glm::dmat3(1));
  flight::BodyState state = body.state();
  state.velocity = {80, 40, 0};
  body.setState(state);
  body.setIntegrator(integrator);
  return body;
}

// Gravity and a drag that grows with the square of the speed.
constexpr auto kDragAndWeight = [](const flight::BodyState& state) {
  constexpr double kDrag = 0.002;  // 1/m, over the mass of 1 kg
  flight::Wrench wrench;
  wrench.force = glm::dvec3(0, -flight::kGravity, 0) - kDrag * glm::length(state.velocity) * state.velocity;
  return wrench;
};

// An aircraft whose stick and throttle are set anew twice a second.
flight::RigidBody flownBody(const MotionParameters& p) {
  flight::AirplaneSettings settings;
  settings.integrator = p.integrator;
  flight::BodyState start;
  start.position = {0, 2000, 0};
  start.velocity = {0, 0, -70};
  flight::Airplane airplane(settings, start);
  core::RandomStream random{5, 0};
  const auto halves = static_cast<int>(p.seconds * 2);
  for (int half = 0; half < halves; ++half) {
    const auto stick = [&] { return 0.5 * (std::floor(random.nextUnit() * 3) - 1); };
    const flight::AirplaneInput input{
        .thrust = random.nextUnit(), .pitch = stick(), .roll = stick(), .yaw = stick()};
    for (std::int64_t i = 0; i < p.rateHz / 2; ++i)
      airplane.step(input, glm::dvec3(0), 1.0 / static_cast<double>(p.rateHz));
  }
  return airplane.body();
}

// A landing on level ground, nose up, at 1 m/s of sink, and the run after it with some brake and rudder.
flight::RigidBody landedBody(const MotionParameters& p) {
  flight::AirplaneSettings settings;
  settings.integrator = p.integrator;
  flight::BodyState start;
  start.position = {0, 1.8, 0};
  start.velocity = {0, -1, -28};
  start.orientation = flight::orientationOf({0, 0.14, 0});
  flight::Airplane airplane(settings, start);
  airplane.setThrottle(0);
  flight::LandingGear gear{flight::GearSettings{}};
  const flight::GearInput wheels{.brake = 0.2, .steer = 0.05};
  const auto meadow = [](const glm::dvec2&) { return flight::GroundPatch{}; };
  const auto steps = static_cast<std::int64_t>(p.seconds * static_cast<double>(p.rateHz));
  for (std::int64_t i = 0; i < steps; ++i)
    airplane.stepOnGround({.idles = true}, {}, 1.0 / static_cast<double>(p.rateHz), gear, wheels, meadow);
  return airplane.body();
}

flight::RigidBody movedBody(const MotionParameters& p) {
  if (p.body == Body::flight) return flownBody(p);
  if (p.body == Body::touchdown) return landedBody(p);
  const bool isThrown = p.body == Body::projectile;
  flight::RigidBody body = isThrown ? thrownBody(p.integrator) : tumblingBody(p.integrator);
  const auto steps = static_cast<std::int64_t>(p.seconds * static_cast<double>(p.rateHz));
  const double dt = 1.0 / static_cast<double>(p.rateHz);
  for (std::int64_t i = 0; i < steps; ++i) {
    if (isThrown) {
      body.update(dt, kDragAndWeight);
    } else {
      body.update(dt);
    }
  }
  return body;
}

class MotionSubject final : public TableSubject<MotionParameters> {
  accuracy::Observation compute(const MotionParameters& p) override {
    const flight::RigidBody body = movedBody(p);
    accuracy::Observation observation;
    observation.positions = {body.position()};
    observation.attitudes = {body.orientation()};
    observation.energies = {body.kineticEnergy()};
    return observation;
  }
  double work(const MotionParameters& p) override { return movedBody(p).orientation().x; }
};

}  // namespace

std::unique_ptr<accuracy::Subject> makeMotionSubject() { return std::make_unique<MotionSubject>(); }

}  // namespace skydrop::app
