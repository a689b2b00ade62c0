// A rigid body: state, mass properties, the forces gathered for the next step, and the choice of integrator.
// Nothing else: what pushes it (Airplane, Package), how it looks and how it sounds are other objects. SI
// units, double, deterministic. Not thread-safe.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "skydrop/flight/integrator.h"

namespace skydrop::flight {

class RigidBody {
 public:
  // Throws core::RangeError when the mass is not positive and finite, the inertia (body axes, kg m^2) is not
  // symmetric, positive definite and well conditioned, the position is not finite or the orientation is not
  // finite or has no length. The orientation is normalised.
  RigidBody(double mass, const glm::dvec3& position, const glm::dquat& orientation,
            const glm::dmat3& inertia);

  // World axes, through the centre of mass; constant during the next update.
  void applyForce(const glm::dvec3& newtons);
  void applyTorque(const glm::dvec3& newtonMetres);
  // Body axes; they turn with the body during the next update.
  void applyRelativeForce(const glm::dvec3& newtons);
  void applyRelativeTorque(const glm::dvec3& newtonMetres);
  // Of all four: a value that is not finite is ignored and counted (Guard::notFiniteForce).

  // Advances by dt seconds under the applied forces, which are then forgotten. dt <= 0 or not finite changes
  // nothing, and keeps the forces. A step that would leave a state that is not finite, or an attitude that is
  // no unit quaternion, is refused and counted (Guard::notFiniteState).
  void update(double dt);
  // The same with further forces that depend on the state and the time, evaluated within the step, so that
  // the integrator's order holds for them too. `time` (s) is that of the step's start on the clock of the
  // caller; the field gets that of each stage. For the same bits everywhere it is made from a whole number of
  // steps, not added up. A step that is too stiff is divided and counted (Guard::stiffStep; integrator.h).
  void update(double dt, const WrenchField& field, double time = 0);

  const BodyState& state() const { return state_; }
  const glm::dvec3& position() const { return state_.position; }
  const glm::dvec3& velocity() const { return state_.velocity; }
  const glm::dquat& orientation() const { return state_.orientation; }
  glm::dvec3 angularVelocity() const {
    return state_.orientation * state_.angularVelocity;
  }  // world axes, rad/s
  double mass() const { return properties_.mass; }
  const MassProperties& properties() const { return properties_; }
  double kineticEnergy() const;        // J
  glm::dvec3 angularMomentum() const;  // world axes, kg m^2/s

  // Places the body. Throws core::RangeError unless all values are finite and the orientation has a length.
  void setState(const BodyState& state);

  // Another mass and inertia, under the constructor's conditions; the state keeps every bit.
  void setMass(double mass, const glm::dmat3& inertia);

  Integrator integrator() const { return integrator_; }
  void setIntegrator(Integrator integrator);

 private:
  MassProperties properties_;
  BodyState state_;
  glm::dvec3 force_{0}, torque_{0};                  // world axes
  glm::dvec3 relativeForce_{0}, relativeTorque_{0};  // body axes
  Integrator integrator_ = Integrator::rk4;
  StepMemory memory_;
};

}  // namespace skydrop::flight
