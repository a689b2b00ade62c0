// How a rigid body is advanced by one step: four integrators over the same right-hand side, so that their
// errors and costs can be compared (docs/flight.md has the measured table).
#pragma once

#include <array>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <string_view>
#include <type_traits>

namespace skydrop::flight {

enum class Integrator {
  thesis,  // the thesis's equations 3.3 to 3.6: Euler, q += dt/2 w q normalised, no gyroscopic term
  semiImplicitEuler,  // velocities first, then positions with the new velocities, attitude by the exponential
                      // map
  rk4,    // classical Runge-Kutta of order 4 on the quaternion's four numbers, normalised after the step
  rkmk4,  // Runge-Kutta of order 4 on the rotation group (Munthe-Kaas 1998)
};
inline constexpr std::array<std::string_view, 4> kIntegratorNames = {"thesis", "semiImplicitEuler", "rk4",
                                                                     "rkmk4"};

// The order of the error over a fixed time as the step shrinks. That of `thesis` holds only where the
// gyroscopic term vanishes; elsewhere it does not converge (P01).
int declaredOrder(Integrator integrator);

// The greatest product of step and rate (of a decay or an oscillation: the spectral radius of the right-hand
// side) that a step takes whole. All decays and damped oscillations below it are stable; the exception is
// `thesis`, which damps an oscillation of angular frequency w only by what its damping ratio has over w dt /
// 2.
double wholeStepBound(Integrator integrator);

struct BodyState {
  glm::dvec3 position{0};              // m, world
  glm::dvec3 velocity{0};              // m/s, world
  glm::dquat orientation{1, 0, 0, 0};  // body to world, unit
  glm::dvec3 angularVelocity{0};       // rad/s, body axes
};

// What acts on a body: a force through the centre of mass in world axes and a torque in body axes.
struct Wrench {
  glm::dvec3 force{0};   // N
  glm::dvec3 torque{0};  // N m
};

struct MassProperties {
  double mass = 1;        // kg, > 0
  glm::dmat3 inertia{1};  // kg m^2, body axes, symmetric and positive definite
  glm::dmat3 inverseInertia{1};
};

// The right-hand side: the wrench as a function of the state and of the time (s, on the clock of who asks for
// the step), asked several times within a step. Made of a callable that takes both, or the state alone. A
// reference to it that it must outlive; not owned, never empty.
class WrenchField {
 public:
  template <class F>
  WrenchField(const F& f)  // implicit on purpose: lambdas are passed in place
      : object_(&f), call_([](const void* o, const BodyState& s, [[maybe_unused]] double time) {
          if constexpr (std::is_invocable_v<const F&, const BodyState&, double>) {
            return (*static_cast<const F*>(o))(s, time);
          } else {
            return (*static_cast<const F*>(o))(s);
          }
        }) {}
  Wrench operator()(const BodyState& state, double time) const { return call_(object_, state, time); }

 private:
  const void* object_;
  Wrench (*call_)(const void*, const BodyState&, double);
};

struct Acceleration {
  glm::dvec3 linear{0};   // m/s^2, world
  glm::dvec3 angular{0};  // rad/s^2, body axes
};

// What one step leaves for the next: it spares the integrators of one stage the second evaluation that tells
// whether the right-hand side is stiff, and after a stiff step the next is examined before it is taken.
// Forgotten (assigned {}) when the body is placed or becomes another.
struct StepMemory {
  Acceleration start;  // at the start of the last step
  bool known = false;
  bool stiff = false;
};

// The state after `dt` seconds (dt > 0 and finite) from `time`. The orientation that comes out is unit within
// 1e-15. Deterministic; without `memory` pure.
//
// A step whose right-hand side is too stiff for it (wholeStepBound) is counted (core::Guard::stiffStep) and
// divided: into at most 128 equal parts of the same integrator, or, where those do not suffice and always for
// `thesis`, into 8 linearly implicit Euler steps, which are stable for any rate and of order 1. Every other
// step is the integrator's own, bit for bit. docs/flight.md tells how it is found out and what it costs.
BodyState integrate(Integrator integrator, const BodyState& state, const MassProperties& body,
                    const WrenchField& wrench, double dt, double time = 0, StepMemory* memory = nullptr);

}  // namespace skydrop::flight
