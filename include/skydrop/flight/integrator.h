// How a rigid body is advanced by one step: four integrators over the same right-hand side, so that their
// errors and costs can be compared (docs/flight.md has the measured table).
#pragma once

#include <array>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <string_view>

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

// The right-hand side: the wrench as a function of the state, asked several times within a step. A reference
// to a callable that outlives the call; not owned, never empty.
class WrenchField {
 public:
  template <class F>
  WrenchField(const F& f)  // implicit on purpose: lambdas are passed in place
      : object_(&f),
        call_([](const void* o, const BodyState& s) { return (*static_cast<const F*>(o))(s); }) {}
  Wrench operator()(const BodyState& state) const { return call_(object_, state); }

 private:
  const void* object_;
  Wrench (*call_)(const void*, const BodyState&);
};

// The state after `dt` seconds (dt > 0 and finite). Pure; the orientation that comes out is unit within
// 1e-15.
BodyState integrate(Integrator integrator, const BodyState& state, const MassProperties& body,
                    const WrenchField& wrench, double dt);

}  // namespace skydrop::flight
