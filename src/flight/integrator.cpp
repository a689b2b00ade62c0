#include "skydrop/flight/integrator.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>

#include "flight/linearised_motion.h"
#include "skydrop/core/guards.h"
#include "skydrop/flight/rotation.h"

namespace skydrop::flight {
namespace {

// A stiff step is divided into so many parts of its own integrator at most; where they do not suffice into
// this many implicit ones.
constexpr double kMostParts = 128;
constexpr int kImplicitParts = 8;

// A step is in doubt when the acceleration changes within it by more than this share of itself. Lowest where
// the bound (wholeStepBound) is lowest. Resolved motion comes this far only where an acceleration passes
// through zero.
constexpr double kRungeKuttaDoubt = 0.9, kSemiImplicitDoubt = 0.6, kThesisDoubt = 0.4;
// Changes below the rounding of the state are noise: relative to the velocity, and of the attitude in
// radians.
constexpr double kRounding = 1e-15;

glm::dvec3 turned(const glm::dquat& q, const glm::dvec3& v) { return q * v; }
glm::dvec3 turnedBack(const glm::dquat& q, const glm::dvec3& v) { return glm::conjugate(q) * v; }

struct Step {
  const MassProperties& body;
  const WrenchField& wrench;
  Integrator integrator;
  double dt, time;
  bool part;  // of a divided step
  StepMemory* memory;

  Dynamics dynamics() const { return {&body, &wrench, integrator != Integrator::thesis}; }
};

// A state that the step met, with its time.
struct Met {
  BodyState state;
  double time;
};

// Greatest product of step and rate of the parts of a stiff step: what the integrator follows well. (At 1 the
// Runge-Kutta integrators take a tenth of the energy of a body that tumbles at 300 rad/s in a second, at .5 a
// thirtieth of that.)
double partBound(Integrator integrator) {
  return integrator == Integrator::semiImplicitEuler ? wholeStepBound(integrator) : 0.5;
}

BodyState whole(const Step& step, const BodyState& s);

[[gnu::cold, gnu::noinline]] BodyState divided(const Step& step, const BodyState& s, double stiffness) {
  if (!step.part) core::countGuard(core::Guard::stiffStep);
  if (step.memory) *step.memory = {.start = {}, .stiff = true};
  const double bound = partBound(step.integrator);
  const bool explicitly =
      !step.part && step.integrator != Integrator::thesis && stiffness <= kMostParts * bound;
  const int parts = explicitly  ? static_cast<int>(std::ceil(stiffness / bound))
                    : step.part ? 1
                                : kImplicitParts;
  BodyState at = s;
  const double dt = step.dt / parts;
  for (int i = 0; i < parts; ++i) {
    const double time = step.time + step.dt * i / parts;
    const Step part{step.body, step.wrench, step.integrator, dt, time, true, nullptr};
    at = explicitly ? whole(part, at) : implicitStep(part.dynamics(), at, part.time, dt);
  }
  return at;
}

// The end of a step that is in doubt: `end` as it is unless the motion about one of the states met is too
// stiff.
[[gnu::cold, gnu::noinline]] BodyState settled(const Step& step, const BodyState& s, const BodyState& end,
                                               std::span<const Met> met) {
  for (const Met& m : met) {
    const double stiffness = LinearisedMotion(step.dynamics(), m.state, m.time, step.dt).stiffness();
    if (stiffness > wholeStepBound(step.integrator)) return divided(step, s, stiffness);
  }
  return end;
}

// Whether `change` exceeds this share of `of` and `noise`; true for NaN. By squares, which vanish below
// 1e-154: so does what they measure.
bool exceeds(const glm::dvec3& change, double share, const glm::dvec3& of, double noise) {
  return !(glm::dot(change, change) <= share * share * glm::dot(of, of) + noise * noise);
}

struct Noise {
  double linear, angular;
};

Noise noiseOf(const BodyState& s, double dt) {
  return {kRounding * (std::abs(s.velocity.x) + std::abs(s.velocity.y) + std::abs(s.velocity.z)) / dt,
          kRounding / (dt * dt)};
}

// For the integrators of one stage: against the start of the step before; without it, and where the step may
// stop or turn a motion, against its own end.
bool oneStageInDoubt(const Step& step, const BodyState& s, const BodyState& end, const Acceleration& start,
                     double share) {
  const auto goesOn = [&](const glm::dvec3& rate, const glm::dvec3& acceleration) {
    return glm::dot(acceleration, acceleration) * step.dt * step.dt <= glm::dot(rate, rate);
  };
  Acceleration before = start, after;
  if (step.memory && step.memory->known && goesOn(s.velocity, start.linear) &&
      goesOn(s.angularVelocity, start.angular)) {
    before = step.memory->start, after = start;
  } else {
    after = step.dynamics()(end, step.time + step.dt);
  }
  if (step.memory) step.memory->start = start, step.memory->known = true;
  const Noise noise = noiseOf(s, step.dt);
  return exceeds(after.linear - before.linear, share, before.linear, noise.linear) ||
         exceeds(after.angular - before.angular, share, before.angular, noise.angular);
}

BodyState stepThesis(const Step& step, const BodyState& s) {
  const MassProperties& body = step.body;
  const double dt = step.dt;
  const Wrench w = step.wrench(s, step.time);
  const Acceleration start{w.force / body.mass, body.inverseInertia * w.torque};
  const glm::dvec3 spin = turned(s.orientation, s.angularVelocity);  // world axes, as in the thesis
  const glm::dvec3 spinRate = turned(s.orientation, start.angular);
  const glm::dvec3 newSpin = spin + spinRate * dt;
  BodyState out;
  out.velocity = s.velocity + start.linear * dt;
  out.position = s.position + s.velocity * dt;
  out.orientation =
      glm::normalize(s.orientation + glm::dquat(0, spin.x, spin.y, spin.z) * s.orientation * (dt / 2));
  out.angularVelocity = turnedBack(out.orientation, newSpin);
  if (oneStageInDoubt(step, s, out, start, kThesisDoubt)) [[unlikely]] {
    return settled(step, s, out, std::array{Met{s, step.time}, Met{out, step.time + dt}});
  }
  return out;
}

// The gyroscopic torque is taken at the end of the step, with one Newton step for it (Catto, GDC 2015): taken
// at the start it doubles the energy of P01 within 3 s.
BodyState stepSemiImplicit(const Step& step, const BodyState& s) {
  const MassProperties& body = step.body;
  const double dt = step.dt;
  const Wrench w = step.wrench(s, step.time);
  const Acceleration start{w.force / body.mass, body.inverseInertia * w.torque};
  glm::dvec3 spin = s.angularVelocity;
  const auto crossMatrix = [](const glm::dvec3& v) {
    return glm::dmat3(0, v.z, -v.y, -v.z, 0, v.x, v.y, -v.x, 0);
  };
  const glm::dvec3 momentum = body.inertia * spin;
  const glm::dvec3 residual = dt * glm::cross(spin, momentum);
  const glm::dmat3 slope = body.inertia + dt * (crossMatrix(spin) * body.inertia - crossMatrix(momentum));
  spin += start.angular * dt - glm::inverse(slope) * residual;
  BodyState out;
  out.velocity = s.velocity + start.linear * dt;
  out.position = s.position + out.velocity * dt;
  out.angularVelocity = spin;
  out.orientation = glm::normalize(s.orientation * exponentialMap(spin * dt));
  if (oneStageInDoubt(step, s, out, start, kSemiImplicitDoubt)) [[unlikely]] {
    return settled(step, s, out, std::array{Met{s, step.time}, Met{out, step.time + dt}});
  }
  return out;
}

// Of the stages of a Runge-Kutta step. Each is held against the one before: where a force ends within the
// step it is the first two or three that tell.
bool stagesInDoubt(const Acceleration& a, const Acceleration& b, const Acceleration& c, const Acceleration& d,
                   const BodyState& s, double dt) {
  const Noise noise = noiseOf(s, dt);
  const auto jumps = [&](const Acceleration& from, const Acceleration& to) {
    return exceeds(to.linear - from.linear, kRungeKuttaDoubt, from.linear, noise.linear) ||
           exceeds(to.angular - from.angular, kRungeKuttaDoubt, from.angular, noise.angular);
  };
  return jumps(a, b) || jumps(b, c) || jumps(c, d);
}

struct Rate {
  glm::dvec3 position, velocity, spin;
  glm::dquat orientation;
};

BodyState stepRk4(const Step& step, const BodyState& s) {
  const MassProperties& body = step.body;
  const double dt = step.dt, middle = step.time + dt / 2, end = step.time + dt;
  const auto rate = [&](const BodyState& at, double time) {
    const Wrench w = step.wrench(at, time);
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
  const Rate a = rate(s, step.time);
  const Rate b = rate(unit(moved(a, dt / 2)), middle);
  const Rate c = rate(unit(moved(b, dt / 2)), middle);
  const Rate d = rate(unit(moved(c, dt)), end);
  const Rate mean{(a.position + 2.0 * (b.position + c.position) + d.position) / 6.0,
                  (a.velocity + 2.0 * (b.velocity + c.velocity) + d.velocity) / 6.0,
                  (a.spin + 2.0 * (b.spin + c.spin) + d.spin) / 6.0,
                  (a.orientation + (b.orientation + c.orientation) * 2.0 + d.orientation) / 6.0};
  const BodyState out = unit(moved(mean, dt));
  if (stagesInDoubt({a.velocity, a.spin}, {b.velocity, b.spin}, {c.velocity, c.spin}, {d.velocity, d.spin}, s,
                    dt)) [[unlikely]] {
    return settled(step, s, out,
                   std::array{Met{s, step.time}, Met{unit(moved(a, dt / 2)), middle},
                              Met{unit(moved(b, dt / 2)), middle}, Met{unit(moved(c, dt)), end}});
  }
  return out;
}

// Munthe-Kaas 1998: the attitude within the step is q0 exp(u), and u, a plain vector, is what Runge-Kutta
// adds up. The inverse differential of exp is cut after two brackets, as order 4 allows (Hairer, Lubich,
// Wanner 2006, IV.8). The angular velocity stays in body axes: carried as momentum in world axes it kept the
// momentum of P01 to rounding and was 470 times worse in attitude.
BodyState stepRkmk4(const Step& step, const BodyState& s) {
  const MassProperties& body = step.body;
  const double dt = step.dt, middle = step.time + dt / 2, end = step.time + dt;
  struct Stage {
    glm::dvec3 position, velocity, turn, spin;
  };
  const auto rate = [&](const BodyState& at, const glm::dvec3& turn, double time) {
    const Wrench w = step.wrench(at, time);
    const glm::dvec3& spin = at.angularVelocity;
    const glm::dvec3 bracket = glm::cross(turn, spin);
    return Stage{at.velocity, w.force / body.mass, spin + 0.5 * bracket + glm::cross(turn, bracket) / 12.0,
                 body.inverseInertia * (w.torque - glm::cross(spin, body.inertia * spin))};
  };
  const auto moved = [&](const Stage& r, double h) {
    return BodyState{s.position + r.position * h, s.velocity + r.velocity * h,
                     s.orientation * exponentialMap(r.turn * h), s.angularVelocity + r.spin * h};
  };
  const Stage a = rate(s, glm::dvec3(0), step.time);
  const Stage b = rate(moved(a, dt / 2), a.turn * (dt / 2), middle);
  const Stage c = rate(moved(b, dt / 2), b.turn * (dt / 2), middle);
  const Stage d = rate(moved(c, dt), c.turn * dt, end);
  const Stage mean{(a.position + 2.0 * (b.position + c.position) + d.position) / 6.0,
                   (a.velocity + 2.0 * (b.velocity + c.velocity) + d.velocity) / 6.0,
                   (a.turn + 2.0 * (b.turn + c.turn) + d.turn) / 6.0,
                   (a.spin + 2.0 * (b.spin + c.spin) + d.spin) / 6.0};
  BodyState out = moved(mean, dt);
  out.orientation = glm::normalize(out.orientation);
  if (stagesInDoubt({a.velocity, a.spin}, {b.velocity, b.spin}, {c.velocity, c.spin}, {d.velocity, d.spin}, s,
                    dt)) [[unlikely]] {
    return settled(step, s, out,
                   std::array{Met{s, step.time}, Met{moved(a, dt / 2), middle}, Met{moved(b, dt / 2), middle},
                              Met{moved(c, dt), end}});
  }
  return out;
}

BodyState whole(const Step& step, const BodyState& s) {
  switch (step.integrator) {
    case Integrator::thesis:
      return stepThesis(step, s);
    case Integrator::semiImplicitEuler:
      return stepSemiImplicit(step, s);
    case Integrator::rk4:
      return stepRk4(step, s);
    case Integrator::rkmk4:
      break;
  }
  return stepRkmk4(step, s);
}

}  // namespace

int declaredOrder(Integrator integrator) {
  return integrator == Integrator::rk4 || integrator == Integrator::rkmk4 ? 4 : 1;
}

double wholeStepBound(Integrator integrator) {
  switch (integrator) {
    case Integrator::thesis:
      return 0.5;  // a decay is stable up to 2, an oscillation never without damping
    case Integrator::semiImplicitEuler:
      return 0.8;  // 2 for a decay or an oscillation; .828 where both meet
    case Integrator::rk4:
    case Integrator::rkmk4:
      break;
  }
  return 2;  // 2.79 on the real and 2.83 on the imaginary axis; where both meet energy may swell from 2 on
}

BodyState integrate(Integrator integrator, const BodyState& state, const MassProperties& body,
                    const WrenchField& wrench, double dt, double time, StepMemory* memory) {
  const Step step{body, wrench, integrator, dt, time, false, memory};
  if (memory && memory->stiff) [[unlikely]] {
    *memory = {};
    const double stiffness = LinearisedMotion(step.dynamics(), state, time, dt).stiffness();
    if (stiffness > wholeStepBound(integrator)) return divided(step, state, stiffness);
  }
  return whole(step, state);
}

}  // namespace skydrop::flight
