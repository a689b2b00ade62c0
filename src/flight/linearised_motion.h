// The motion of a body linearised about one state: how stiff it is for a step, and a step that is stable
// however stiff it is. Each linearisation asks the right-hand side 13 times: for steps that are in doubt, not
// for every one.
#pragma once

#include <array>

#include "skydrop/flight/integrator.h"

namespace skydrop::flight {

// The right-hand side as accelerations.
struct Dynamics {
  const MassProperties* body;
  const WrenchField* wrench;
  bool gyroscopic;  // whether the angular acceleration holds the gyroscopic term

  Acceleration operator()(const BodyState& at, double time) const;
};

class LinearisedMotion {
 public:
  // By differences over small displacements of position, attitude (body axes), velocity and angular velocity.
  LinearisedMotion(const Dynamics& dynamics, const BodyState& at, double time, double dt);

  // `dt` times the spectral radius: of a pure decay dt times its rate, of an oscillation dt times its angular
  // frequency. At most 10 % too high. NaN where the right-hand side is not finite.
  double stiffness() const;

  const Acceleration& acceleration() const { return acceleration_; }

  // (1 - dt Jv - dt^2 Jx)^-1 times a change of the velocities: how the velocities at the end of an implicit
  // step answer to it. Not finite where the matrix is singular.
  Acceleration answerTo(const Acceleration& change) const;

 private:
  using Matrix6 = std::array<std::array<double, 6>, 6>;

  Acceleration acceleration_;
  Matrix6 byVelocity_{}, byPlace_{};  // dt Jv and dt^2 Jx: rows are accelerations
};

// A step of implicit Euler, stable however stiff the motion is: of order 1, it damps what it cannot resolve.
// The velocities solve u1 = u0 + dt a(place + dt u1, u1, time + dt) by Newton steps that are halved until
// they help: one for a linear force (Baraff, Witkin, SIGGRAPH 1998, section 3), at most four, so that of a
// force with a corner (friction, contact) it makes part of the way. Where a Newton step does not help the way
// of the force itself is tried, and where that does not either the velocities stay. Not finite where the
// forces are not.
BodyState implicitStep(const Dynamics& dynamics, const BodyState& start, double time, double dt);

}  // namespace skydrop::flight
