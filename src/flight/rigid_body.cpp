#include "skydrop/flight/rigid_body.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "skydrop/core/error.h"
#include "skydrop/core/guards.h"

namespace skydrop::flight {
namespace {

using core::isFinite;

bool isFinite(const glm::dquat& q) {
  return std::isfinite(q.w) && std::isfinite(q.x) && std::isfinite(q.y) && std::isfinite(q.z);
}

// An attitude that was divided by an infinite length is finite, and 0.
bool isUsable(const BodyState& s) {
  return isFinite(s.position) && isFinite(s.velocity) && isFinite(s.angularVelocity) &&
         isFinite(s.orientation) && std::abs(glm::dot(s.orientation, s.orientation) - 1) < 1e-9;
}

glm::dquat checkedUnit(const glm::dquat& q) {
  const double length = glm::length(q);
  if (!isFinite(q) || !(length > 1e-6) || !std::isfinite(length)) {
    throw core::RangeError("rigid body: the orientation is not a finite quaternion with a length");
  }
  return q / length;
}

MassProperties checkedProperties(double mass, const glm::dmat3& inertia) {
  if (!std::isfinite(mass) || mass <= 0)
    throw core::RangeError("rigid body: the mass must be positive and finite");
  double largest = 0;
  for (int column = 0; column < 3; ++column) {
    if (!isFinite(inertia[column])) throw core::RangeError("rigid body: the inertia is not finite");
    for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(inertia[column][row]));
  }
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < column; ++row) {
      if (std::abs(inertia[column][row] - inertia[row][column]) > 1e-9 * largest) {
        throw core::RangeError("rigid body: the inertia is not symmetric");
      }
    }
  }
  // Sylvester: positive definite exactly when the leading minors are positive; scaled, so that nearly
  // singular is told from small. 1e-9 leaves the inverse at least 7 good digits.
  const glm::dmat3 m = inertia / largest;
  const double first = m[0][0], second = m[0][0] * m[1][1] - m[1][0] * m[0][1], third = glm::determinant(m);
  if (!(largest > 0) || !(first > 1e-9) || !(second > 1e-9) || !(third > 1e-9)) {
    throw core::RangeError("rigid body: the inertia is singular or not positive definite");
  }
  return {mass, inertia, glm::inverse(m) / largest};
}

void gather(glm::dvec3& sum, const glm::dvec3& value) {
  if (isFinite(value)) {
    sum += value;
  } else {
    core::countGuard(core::Guard::notFiniteForce);
  }
}

}  // namespace

RigidBody::RigidBody(double mass, const glm::dvec3& position, const glm::dquat& orientation,
                     const glm::dmat3& inertia)
    : properties_(checkedProperties(mass, inertia)) {
  BodyState start;
  start.position = position;
  start.orientation = orientation;
  setState(start);
}

void RigidBody::applyForce(const glm::dvec3& newtons) { gather(force_, newtons); }
void RigidBody::applyTorque(const glm::dvec3& newtonMetres) { gather(torque_, newtonMetres); }
void RigidBody::applyRelativeForce(const glm::dvec3& newtons) { gather(relativeForce_, newtons); }
void RigidBody::applyRelativeTorque(const glm::dvec3& newtonMetres) { gather(relativeTorque_, newtonMetres); }

void RigidBody::update(double dt) {
  update(dt, [](const BodyState&) { return Wrench{}; });
}

void RigidBody::update(double dt, const WrenchField& field, double time) {
  if (!std::isfinite(dt) || dt <= 0) return;
  const auto total = [&](const BodyState& at, double stageTime) {
    Wrench w = field(at, stageTime);
    w.force += force_ + at.orientation * relativeForce_;
    w.torque += relativeTorque_ + glm::conjugate(at.orientation) * torque_;
    return w;
  };
  const BodyState next = integrate(integrator_, state_, properties_, total, dt, time, &memory_);
  if (isUsable(next)) {
    state_ = next;
  } else {
    core::countGuard(core::Guard::notFiniteState);
  }
  force_ = torque_ = relativeForce_ = relativeTorque_ = glm::dvec3(0);
}

double RigidBody::kineticEnergy() const {
  const glm::dvec3& spin = state_.angularVelocity;
  return 0.5 * properties_.mass * glm::dot(state_.velocity, state_.velocity) +
         0.5 * glm::dot(spin, properties_.inertia * spin);
}

glm::dvec3 RigidBody::angularMomentum() const {
  return state_.orientation * (properties_.inertia * state_.angularVelocity);
}

void RigidBody::setState(const BodyState& state) {
  if (!isFinite(state.position) || !isFinite(state.velocity) || !isFinite(state.angularVelocity)) {
    throw core::RangeError("rigid body: position, velocity or angular velocity is not finite");
  }
  const glm::dquat orientation = checkedUnit(state.orientation);
  state_ = state;
  state_.orientation = orientation;
  memory_ = {};
}

void RigidBody::setMass(double mass, const glm::dmat3& inertia) {
  properties_ = checkedProperties(mass, inertia);
  memory_ = {};
}

void RigidBody::setIntegrator(Integrator integrator) {
  integrator_ = integrator;
  memory_ = {};
}

}  // namespace skydrop::flight
