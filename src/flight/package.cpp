#include "skydrop/flight/package.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "skydrop/core/error.h"
#include "skydrop/core/guards.h"
#include "skydrop/flight/environment.h"

namespace skydrop::flight {
namespace {

// Under the canopy the box swings like a pendulum: this frequency and damping ratio, once it is open.
constexpr double kSwingRadPerS = 3;
constexpr double kSwingDamping = 0.4;
// Without it the tumbling dies away slowly, 1/s.
constexpr double kTumbleDamping = 0.3;
// It is pushed out at one end, which gives a package of the default mass (kg) and size (m) this spin beside
// the aircraft's own, nose down, rad/s. The same push turns others by 1 / (mass * size): the arm is half an
// edge, the inertia mass * size^2 / 6. Small and light ones are let go before they turn faster than the most.
constexpr double kReleaseSpin = -1.2, kReleaseMass = 60, kReleaseSize = 0.8, kMostReleaseSpin = -12;

void requireUsable(const PackageSettings& s) {
  for (const double positive : {s.mass, s.size, s.freeFallSpeed, s.parachuteSpeed}) {
    if (!std::isfinite(positive) || positive <= 0) {
      throw core::RangeError("package: mass, size and both speeds must be positive and finite");
    }
  }
  for (const double notNegative : {s.parachuteDelay, s.parachuteOpening}) {
    if (!std::isfinite(notNegative) || notNegative < 0) {
      throw core::RangeError("package: delay and opening must be finite and not negative");
    }
  }
}

RigidBody makeBody(const PackageSettings& s, const BodyState& release) {
  requireUsable(s);
  const double inertia = s.mass * s.size * s.size / 6;  // of a cube
  RigidBody body(s.mass, release.position, release.orientation, glm::dmat3(inertia));
  BodyState state = release;
  state.angularVelocity.x +=
      std::max(kReleaseSpin * (kReleaseMass * kReleaseSize / (s.mass * s.size)), kMostReleaseSpin);
  body.setState(state);
  return body;
}

// What the canopy does. Within each, the drag is a smooth function of the time; between two it is not.
enum class Canopy { packed, opening, open };

// An end nearer than this counts as reached, s: the rounding of an age that is added up.
constexpr double kInstant = 1e-9;

Canopy canopyAt(const PackageSettings& s, double age) {
  const double since = age + kInstant - s.parachuteDelay;
  if (since < 0) return Canopy::packed;
  return since < s.parachuteOpening ? Canopy::opening : Canopy::open;
}

double endOf(const PackageSettings& s, Canopy canopy) {
  if (canopy == Canopy::open) return std::numeric_limits<double>::infinity();
  return canopy == Canopy::packed ? s.parachuteDelay : s.parachuteDelay + s.parachuteOpening;
}

double openIn(const PackageSettings& s, Canopy canopy, double age) {
  if (canopy != Canopy::opening) return canopy == Canopy::open ? 1 : 0;
  const double t = std::clamp((age - s.parachuteDelay) / s.parachuteOpening, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

// Cuts dt > 0 seconds from `age` on where the canopy begins to open and where it is open: advance(canopy,
// age, seconds) for each part in turn.
template <class Advance>
void forEachPart(const PackageSettings& s, double age, double dt, const Advance& advance) {
  const double end = age + dt;
  while (age < end) {
    const Canopy canopy = canopyAt(s, age);
    double to = std::min(end, endOf(s, canopy));
    if (end - to < kInstant) to = end;
    advance(canopy, age, to - age);
    age = to;
  }
}

// The fall within a part. While the canopy opens two steps of constant drag stand for it, the rates mixed of
// those at the two points of Gauss and Legendre: of order 4 (commutator-free Magnus: Celledoni, Marthinsen,
// Owren 2003). The guard against a negative rate matters where an opening is far shorter than a step.
PointState fallIn(const PackageSettings& s, Canopy canopy, const PointState& state, double age,
                  const glm::dvec3& wind, double dt) {
  const auto rateAt = [&](double share) { return dragRateAt(s, openIn(s, canopy, age + share * dt)); };
  if (canopy != Canopy::opening) return fallWithLinearDrag(state, rateAt(0), wind, dt);
  constexpr double kSqrt3 = 1.7320508075688772;
  constexpr double kNear = 0.5 + kSqrt3 / 3, kFar = 0.5 - kSqrt3 / 3;
  const double early = rateAt(0.5 - kSqrt3 / 6), late = rateAt(0.5 + kSqrt3 / 6);
  const double first = std::max(kNear * early + kFar * late, 0.0),
               second = std::max(kNear * late + kFar * early, 0.0);
  return fallWithLinearDrag(fallWithLinearDrag(state, first, wind, dt / 2), second, wind, dt / 2);
}

// The fall over `dt` seconds within one phase (before, during or after the opening). The drag changes during
// the opening only: 24 steps for all of it stay within a millimetre of the 120 Hz path.
PointState fallFor(const PackageSettings& s, PointState state, double age, const glm::dvec3& wind,
                   double dt) {
  constexpr int kOpeningSteps = 24;
  const bool opening = age >= s.parachuteDelay && age < s.parachuteDelay + s.parachuteOpening;
  const int steps = opening ? static_cast<int>(std::ceil(dt * kOpeningSteps / s.parachuteOpening)) : 1;
  for (int i = 0; i < steps; ++i) state = packageStep(s, state, age + dt * i / steps, wind, dt / steps);
  return state;
}

}  // namespace

double parachuteOpenAt(const PackageSettings& s, double age) {
  if (age <= s.parachuteDelay) return 0;
  if (age >= s.parachuteDelay + s.parachuteOpening) return 1;
  return openIn(s, Canopy::opening, age);
}

double dragRateAt(const PackageSettings& s, double open) {
  const double packed = kGravity / s.freeFallSpeed, full = kGravity / s.parachuteSpeed;
  return packed + (full - packed) * open;
}

PointState packageStep(const PackageSettings& s, PointState state, double age, const glm::dvec3& wind,
                       double dt) {
  forEachPart(s, age, dt, [&](Canopy canopy, double from, double seconds) {
    state = fallIn(s, canopy, state, from, wind, seconds);
  });
  return state;
}

Package::Package(const PackageSettings& settings, const BodyState& release)
    : settings_(settings), body_(makeBody(settings, release)) {}

void Package::step(const glm::dvec3& wind, double dt) {
  if (landed_ || !std::isfinite(dt) || dt <= 0) return;
  const double inertia = body_.properties().inertia[0][0];
  forEachPart(settings_, age_, dt, [&](Canopy canopy, double age, double seconds) {
    const PointState start{body_.position(), body_.velocity()};
    // Canopy and airflow are those of the stage's own time, or the rotation would be of order 1.
    const auto swing = [&](const BodyState& at, double time) {
      const glm::dvec3 through = fallIn(settings_, canopy, start, age, wind, time - age).velocity - wind;
      // The lines pull the box's up axis against the airflow; without airflow there is no pull.
      const double speed = glm::length(through);
      const double pull = openIn(settings_, canopy, time) * std::min(speed / settings_.parachuteSpeed, 1.0);
      const glm::dvec3 against = speed > 1e-9 ? through / -speed : glm::dvec3(0, 1, 0);
      const glm::dvec3 up = glm::conjugate(at.orientation) * against;
      Wrench w;
      w.torque = inertia * (kSwingRadPerS * kSwingRadPerS * pull * glm::cross(glm::dvec3(0, 1, 0), up) -
                            (kTumbleDamping + 2 * kSwingDamping * kSwingRadPerS * pull) * at.angularVelocity);
      return w;
    };
    body_.update(seconds, swing, age);
    const PointState moved = fallIn(settings_, canopy, start, age, wind, seconds);
    BodyState next = body_.state();
    next.position = moved.position;
    next.velocity = moved.velocity;
    body_.setState(next);
  });
  age_ += dt;
}

void Package::land(const glm::dvec3& position) {
  BodyState rest = body_.state();
  rest.position = position;
  rest.velocity = rest.angularVelocity = glm::dvec3(0);
  body_.setState(rest);
  landed_ = true;
}

namespace {

// The wind of a step of the prediction from `from` on, `left` above the surface, and how long the step may be
// at most because of it. One form of it for a wind that is the same everywhere, so that this costs nothing.
struct EvenWind {
  glm::dvec3 velocity;
  double longest(double, const PointState&) const { return kLongestFallSeconds; }
  glm::dvec3 over(const PointState&, double, double) const { return velocity; }
};
struct ChangingWind {
  const WindField& field;
  double longest(double left, const PointState& from) const {
    return std::max(0.2 * left, 6.0) / std::max(std::abs(from.velocity.y), 1.0);
  }
  glm::dvec3 over(const PointState& from, double left, double dt) const {
    const glm::dvec3 middle = from.position + from.velocity * (0.5 * dt);
    // The surface below the start of the step: near enough for the wind.
    return field(middle, from.position.y - left);
  }
};

template <class Wind>
std::optional<Landing> landingIn(const PackageSettings& s, const PointState& start, const Wind& wind,
                                 const std::function<double(const glm::dvec2&)>& surfaceHeight,
                                 double startAge) {
  if (!core::isFinite(start.position) || !core::isFinite(start.velocity)) return {};
  if (!std::isfinite(startAge) || startAge < 0) return {};
  const auto clearance = [&](const PointState& p) {
    return p.position.y - surfaceHeight({p.position.x, p.position.z});
  };
  // The ground is asked each 20 m of way, or where it is further below, after a quarter of that distance: a
  // ridge of slope 4 is not flown through.
  constexpr double kSampleMetres = 20;
  const double opened = s.parachuteDelay + s.parachuteOpening;
  PointState from = start;
  double age = startAge, left = clearance(from);
  if (left <= 0) return Landing{{from.position.x, from.position.y - left, from.position.z}, 0};
  while (age < kLongestFallSeconds) {
    const double way = std::max(kSampleMetres, 0.25 * left);
    double dt = way / std::max(glm::length(from.velocity), s.parachuteSpeed);
    if (age < s.parachuteDelay) {
      dt = std::min(dt, s.parachuteDelay - age);
    } else if (age < opened) {
      dt = std::min(dt, opened - age);
    } else {
      const double sideways = glm::length(glm::dvec2(from.velocity.x, from.velocity.z));
      dt = std::min(way / std::max(sideways, 1e-3), std::max(0.5 * left / s.parachuteSpeed, 0.1));
    }
    dt = std::min(dt, wind.longest(left, from));
    const glm::dvec3 moves = wind.over(from, left, dt);
    const PointState to = fallFor(s, from, age, moves, dt);
    const double leftAfter = clearance(to);
    if (leftAfter <= 0) {
      // The crossing inside this step, to a millimetre: false position with a halved stale end (Illinois:
      // Dowell, Jarratt 1971).
      double low = 0, high = dt, atLow = left, atHigh = leftAfter, t = dt;
      int side = 0;
      PointState hit = to;
      for (int i = 0; i < 60; ++i) {
        t = (low * atHigh - high * atLow) / (atHigh - atLow);
        hit = fallFor(s, from, age, moves, t);
        const double at = clearance(hit);
        if (std::abs(at) < 1e-3) break;
        if (at > 0) {
          low = t, atLow = at;
          if (side == 1) atHigh *= 0.5;
          side = 1;
        } else {
          high = t, atHigh = at;
          if (side == -1) atLow *= 0.5;
          side = -1;
        }
      }
      return Landing{{hit.position.x, surfaceHeight({hit.position.x, hit.position.z}), hit.position.z},
                     age + t - startAge};
    }
    from = to;
    age += dt;
    left = leftAfter;
  }
  return {};
}

}  // namespace

std::optional<Landing> predictLanding(const PackageSettings& s, const PointState& state,
                                      const glm::dvec3& wind,
                                      const std::function<double(const glm::dvec2&)>& surfaceHeight,
                                      double age) {
  requireUsable(s);
  if (!core::isFinite(wind)) return {};
  return landingIn(s, state, EvenWind{wind}, surfaceHeight, age);
}

std::optional<Landing> predictLanding(const PackageSettings& s, const PointState& state,
                                      const WindField& wind,
                                      const std::function<double(const glm::dvec2&)>& surfaceHeight,
                                      double age) {
  requireUsable(s);
  return landingIn(s, state, ChangingWind{wind}, surfaceHeight, age);
}

}  // namespace skydrop::flight
