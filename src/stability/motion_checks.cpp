#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <initializer_list>

#include "skydrop/core/fixed_step.h"
#include "skydrop/flight/environment.h"
#include "skydrop/flight/linear_drag.h"
#include "skydrop/flight/rigid_body.h"
#include "skydrop/flight/rotation.h"
#include "stability/checks.h"
#include "stability/projectile.h"

namespace skydrop::stability {
namespace {

using namespace flight;

RigidBody spinning(const glm::dmat3& inertia, const glm::dvec3& spin, Integrator integrator) {
  RigidBody body(1, glm::dvec3(0), glm::dquat(1, 0, 0, 0), inertia);
  BodyState state;
  state.angularVelocity = spin;
  body.setState(state);
  body.setIntegrator(integrator);
  return body;
}

// A body that tumbles freely for 10 s at 120 Hz, by both Runge-Kutta integrators.
template <class Error>
double worstOfFreeBodies(const Error& error) {
  double worst = 0;
  for (const Integrator integrator : {Integrator::rk4, Integrator::rkmk4}) {
    const glm::dmat3 inertia(10, 0, 0, 0, 20, 0, 0, 0, 26);
    const RigidBody start = spinning(inertia, {1, 15, 1}, integrator);
    RigidBody body = start;
    for (int i = 0; i < 1200; ++i) body.update(1.0 / 120);
    worst = std::max(worst, error(start, body));
  }
  return worst;
}

double apart(double found, long double truth) { return std::abs(found - static_cast<double>(truth)); }

}  // namespace

double freeBodyEnergyError() {
  return worstOfFreeBodies([](const RigidBody& start, const RigidBody& end) {
    return std::abs(end.kineticEnergy() / start.kineticEnergy() - 1);
  });
}

double freeBodyMomentumError() {
  return worstOfFreeBodies([](const RigidBody& start, const RigidBody& end) {
    return glm::length(end.angularMomentum() - start.angularMomentum()) /
           glm::length(start.angularMomentum());
  });
}

double constantRotationError() {
  const glm::dvec3 axis = glm::normalize(glm::dvec3(1, -2, 3));
  double worst = 0;
  for (const double perStep : {1.0, 2.0, 3.14, 20.0}) {
    for (const Integrator integrator : {Integrator::semiImplicitEuler, Integrator::rkmk4}) {
      RigidBody body = spinning(glm::dmat3(5), axis * (perStep / 0.25), integrator);
      glm::dquat mapped(1, 0, 0, 0);
      for (int i = 0; i < 50; ++i) {
        body.update(0.25);
        mapped = glm::normalize(mapped * exponentialMap(axis * perStep));
      }
      const long double half = 25.0L * perStep;
      const auto s = static_cast<double>(sinl(half));
      const glm::dquat truth(static_cast<double>(cosl(half)), s * axis.x, s * axis.y, s * axis.z);
      for (const glm::dquat& q : {body.orientation(), mapped})
        worst = std::max(worst, glm::length(glm::dot(q, truth) < 0 ? q + truth : q - truth));
    }
  }
  return worst;
}

double exponentialStepError() {
  double worst = 0;
  for (const double k : {0.0, 1e-12, 1e-6, 0.05, 0.16, 1.2, 9.81, 100.0}) {
    for (const double t : {1e-3, 1.0 / 120, 0.1, 1.0, 7.5, 60.0, 1000.0}) {
      const PointState end = fallWithLinearDrag({{0, 0, 0}, {70, 10, 0}}, k, glm::dvec3(0), t);
      const Truth truth = projectile(70, 10, k, t);
      const double scale = 70 * t + 0.5 * kGravity * t * t;  // what the terms of the distance cover
      worst = std::max({worst, apart(end.position.x, truth.x) / scale, apart(end.position.y, truth.y) / scale,
                        apart(end.velocity.x, truth.vx) / 70,
                        apart(end.velocity.y, truth.vy) / (10 + kGravity * t)});
    }
  }
  return worst;
}

double manySmallStepsError() {
  const PointState start{{0, 1000, 0}, {70, 0, -20}};
  const glm::dvec3 wind{5, 0, 3};
  PointState many = start;
  for (int i = 0; i < 7200; ++i) many = fallWithLinearDrag(many, 0.4, wind, 1.0 / 120);
  return glm::length(many.position - fallWithLinearDrag(start, 0.4, wind, 60).position);
}

double stepLengthError() {
  using core::FixedStep;
  double worst = 0;
  for (std::uint64_t step = 1'200'000'000; step < 1'200'000'240; ++step) {
    const double length = FixedStep::secondsOf(step + 1) - FixedStep::secondsOf(step);
    worst = std::max(worst, std::abs(length - 1.0 / 120));
  }
  return worst;
}

double lostSteps() {
  core::FixedStep clock;
  for (int frame = 0; frame < 3'000'000; ++frame) clock.advance(1.0 / 144);
  return std::abs(static_cast<double>(clock.stepCount()) - 2'500'000);
}

}  // namespace skydrop::stability
