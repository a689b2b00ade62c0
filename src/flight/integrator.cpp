#include "skydrop/flight/integrator.h"

#include <glm/geometric.hpp>

#include "skydrop/flight/rotation.h"

namespace skydrop::flight {
namespace {

glm::dvec3 turned(const glm::dquat& q, const glm::dvec3& v) { return q * v; }
glm::dvec3 turnedBack(const glm::dquat& q, const glm::dvec3& v) { return glm::conjugate(q) * v; }

BodyState stepThesis(const BodyState& s, const MassProperties& body, const WrenchField& field, double dt) {
  const Wrench w = field(s);
  const glm::dvec3 spin = turned(s.orientation, s.angularVelocity);  // world axes, as in the thesis
  const glm::dvec3 spinRate = turned(s.orientation, body.inverseInertia * w.torque);
  const glm::dvec3 newSpin = spin + spinRate * dt;
  BodyState out;
  out.velocity = s.velocity + w.force / body.mass * dt;
  out.position = s.position + s.velocity * dt;
  out.orientation =
      glm::normalize(s.orientation + glm::dquat(0, spin.x, spin.y, spin.z) * s.orientation * (dt / 2));
  out.angularVelocity = turnedBack(out.orientation, newSpin);
  return out;
}

// The gyroscopic torque is taken at the end of the step, with one Newton step for it (Catto, GDC 2015): taken
// at the start it doubles the energy of P01 within 3 s.
BodyState stepSemiImplicit(const BodyState& s, const MassProperties& body, const WrenchField& field,
                           double dt) {
  const Wrench w = field(s);
  glm::dvec3 spin = s.angularVelocity;
  const auto crossMatrix = [](const glm::dvec3& v) {
    return glm::dmat3(0, v.z, -v.y, -v.z, 0, v.x, v.y, -v.x, 0);
  };
  const glm::dvec3 momentum = body.inertia * spin;
  const glm::dvec3 residual = dt * glm::cross(spin, momentum);
  const glm::dmat3 slope = body.inertia + dt * (crossMatrix(spin) * body.inertia - crossMatrix(momentum));
  spin += body.inverseInertia * w.torque * dt - glm::inverse(slope) * residual;
  BodyState out;
  out.velocity = s.velocity + w.force / body.mass * dt;
  out.position = s.position + out.velocity * dt;
  out.angularVelocity = spin;
  out.orientation = glm::normalize(s.orientation * exponentialMap(spin * dt));
  return out;
}

struct Rate {
  glm::dvec3 position, velocity, spin;
  glm::dquat orientation;
};

BodyState stepRk4(const BodyState& s, const MassProperties& body, const WrenchField& field, double dt) {
  const auto rate = [&](const BodyState& at) {
    const Wrench w = field(at);
    const glm::dvec3& spin = at.angularVelocity;
    return Rate{at.velocity, w.force / body.mass,
                body.inverseInertia * (w.torque - glm::cross(spin, body.inertia * spin)),
                at.orientation * glm::dquat(0, spin.x, spin.y, spin.z) * 0.5};
  };
  const auto moved = [&](const Rate& r, double h) {
    return BodyState{s.position + r.position * h, s.velocity + r.velocity * h,
                     s.orientation + r.orientation * h, s.angularVelocity + r.spin * h};
  };
  // A stage's orientation is not unit; forces see the direction it stands for.
  const auto unit = [](BodyState at) {
    at.orientation = glm::normalize(at.orientation);
    return at;
  };
  const Rate a = rate(s);
  const Rate b = rate(unit(moved(a, dt / 2)));
  const Rate c = rate(unit(moved(b, dt / 2)));
  const Rate d = rate(unit(moved(c, dt)));
  const Rate mean{(a.position + 2.0 * (b.position + c.position) + d.position) / 6.0,
                  (a.velocity + 2.0 * (b.velocity + c.velocity) + d.velocity) / 6.0,
                  (a.spin + 2.0 * (b.spin + c.spin) + d.spin) / 6.0,
                  (a.orientation + (b.orientation + c.orientation) * 2.0 + d.orientation) / 6.0};
  return unit(moved(mean, dt));
}

// Munthe-Kaas 1998: the attitude within the step is q0 exp(u), and u, a plain vector, is what Runge-Kutta
// adds up. The inverse differential of exp is cut after two brackets, as order 4 allows (Hairer, Lubich,
// Wanner 2006, IV.8). The angular velocity stays in body axes: carried as momentum in world axes it kept the
// momentum of P01 to rounding and was 470 times worse in attitude.
BodyState stepRkmk4(const BodyState& s, const MassProperties& body, const WrenchField& field, double dt) {
  struct Stage {
    glm::dvec3 position, velocity, turn, spin;
  };
  const auto rate = [&](const BodyState& at, const glm::dvec3& turn) {
    const Wrench w = field(at);
    const glm::dvec3& spin = at.angularVelocity;
    const glm::dvec3 bracket = glm::cross(turn, spin);
    return Stage{at.velocity, w.force / body.mass, spin + 0.5 * bracket + glm::cross(turn, bracket) / 12.0,
                 body.inverseInertia * (w.torque - glm::cross(spin, body.inertia * spin))};
  };
  const auto moved = [&](const Stage& r, double h) {
    return BodyState{s.position + r.position * h, s.velocity + r.velocity * h,
                     s.orientation * exponentialMap(r.turn * h), s.angularVelocity + r.spin * h};
  };
  const Stage a = rate(s, glm::dvec3(0));
  const Stage b = rate(moved(a, dt / 2), a.turn * (dt / 2));
  const Stage c = rate(moved(b, dt / 2), b.turn * (dt / 2));
  const Stage d = rate(moved(c, dt), c.turn * dt);
  const Stage mean{(a.position + 2.0 * (b.position + c.position) + d.position) / 6.0,
                   (a.velocity + 2.0 * (b.velocity + c.velocity) + d.velocity) / 6.0,
                   (a.turn + 2.0 * (b.turn + c.turn) + d.turn) / 6.0,
                   (a.spin + 2.0 * (b.spin + c.spin) + d.spin) / 6.0};
  BodyState out = moved(mean, dt);
  out.orientation = glm::normalize(out.orientation);
  return out;
}

}  // namespace

int declaredOrder(Integrator integrator) {
  return integrator == Integrator::rk4 || integrator == Integrator::rkmk4 ? 4 : 1;
}

BodyState integrate(Integrator integrator, const BodyState& state, const MassProperties& body,
                    const WrenchField& wrench, double dt) {
  switch (integrator) {
    case Integrator::thesis:
      return stepThesis(state, body, wrench, dt);
    case Integrator::semiImplicitEuler:
      return stepSemiImplicit(state, body, wrench, dt);
    case Integrator::rk4:
      return stepRk4(state, body, wrench, dt);
    case Integrator::rkmk4:
      break;
  }
  return stepRkmk4(state, body, wrench, dt);
}

}  // namespace skydrop::flight
