#include "game/landing_pilot.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "game/angle.h"
#include "game/steps.h"
#include "game/stick.h"
#include "skydrop/core/deterministic_math.h"

namespace skydrop::game {
namespace {

namespace dmath = core::dmath;

// The approach: from a gate so far before the strip, down a path that ends so far behind its beginning, m.
constexpr double kGateMetres = 2000, kAimMetres = 60, kJoinMetres = 2500, kJoinRadius = 700,
                 kFinalSlope = 0.055;
constexpr double kSteepestFinal = 0.12;  // that an idle engine holds, m a metre
// How near the gate, and how well along the strip, the final begins: m, radians.
constexpr double kGateRadius = 400, kGateAheadRad = 0.9;
constexpr double kFinalSpeed = 37, kFlareHeight = 7;  // m/s, m of the wheels
constexpr double kWheelHeight = 1.55;                 // of the middle over the wheels, m
// Lost: higher than this over the path or further beside it at the strip, m, it flies round again.
constexpr double kMostAside = 60, kMostHigh = 40;
constexpr double kDecisionHeight = 60;  // above the strip, m: lower, it goes round where the wind asks for it
constexpr double kMostGustMargin = 4;   // m/s
// A flare that a gust breaks: it sinks faster than it should, m/s, and is caught with so much thrust.
constexpr double kSinksTooFast = 0.8, kCatchThrust = 0.7;
// What it lands in, at the height where it looks: wind across the strip, gusts (standard deviation), m/s.
constexpr double kMostCrosswind = 8, kMostGusts = 2.5;
constexpr double kRotateSpeed = 38, kClimbRad = 0.14, kAwayHeight = 60;
constexpr double kTakeOffMetres = 280;
constexpr double kBesideMetres = 60;  // beside a strip it is still used, m
constexpr double kStopSeconds = 2;

double trackOf(const glm::dvec3& v) { return dmath::atan2(v.x, -v.z); }

// The stick that holds a path angle and a bank, as the autopilot's.
void hold(Controls& out, const AircraftSnapshot& craft, double climb, double bank) {
  out.pitch = std::clamp(pitchTo(craft, climb, 3), -1.0, 1.0);
  out.roll = rollTo(craft, bank);
}

// Levers that bring the airspeed to one that is wanted: full range within 6 m/s.
void holdSpeed(Controls& out, double airspeed, double wanted) {
  const double asked = std::clamp((wanted - airspeed) / 6, -1.0, 1.0);
  out.thrust = std::max(asked, 0.0);
  out.brake = std::max(-asked, 0.0);
}

// What is added to the speed of the final in gusts, m/s.
double gustMargin(const Snapshot& now) {
  return now.air.present ? std::min(now.air.turbulenceMps, kMostGustMargin) : 0;
}

}  // namespace

bool LandingPilot::isCalmEnough(const terrain::Strip& strip, const Snapshot& now) {
  const double across = now.wind.x * strip.along.y - now.wind.z * strip.along.x;
  return std::abs(across) < kMostCrosswind && (!now.air.present || now.air.turbulenceMps < kMostGusts);
}

void LandingPilot::begin(const terrain::Strip& strip, const Snapshot& now) {
  strip_ = strip;
  if (strip.bothWays && now.wind.x * strip.along.x + now.wind.z * strip.along.y > 0)
    strip_ = strip.reversed();
  phase_ = Phase::approach;
  stoppedSteps_ = 0;
  flares_ = joined_ = false;
}

void LandingPilot::beginTakeOff(const std::optional<terrain::Strip>& strip, const Snapshot& now) {
  const AircraftSnapshot& craft = now.aircraft;
  const glm::dvec2 ahead(dmath::sin(craft.headingRad), -dmath::cos(craft.headingRad));
  const glm::dvec2 here(craft.position.x, craft.position.z);
  const glm::dvec2 onStrip = strip ? strip->local(here) : glm::dvec2(0);
  if (strip && std::abs(onStrip.x) < strip->halfLength + kBesideMetres &&
      std::abs(onStrip.y) < strip->halfWidth + kBesideMetres) {
    strip_ = ahead.x * strip->along.x + ahead.y * strip->along.y >= 0 ? *strip : strip->reversed();
  } else {  // wherever the nose points
    strip_ = {.middle = here, .height = craft.groundHeight, .along = ahead, .halfLength = 1e6};
  }
  stoppedSteps_ = 0;
  const bool fits = strip_.halfLength - strip_.local(here).x > kTakeOffMetres;
  phase_ = fits ? Phase::takeOff : Phase::turnRound;
  if (!fits) strip_ = strip_.reversed();
}

glm::dvec2 LandingPilot::gate() const {
  return strip_.world(-strip_.halfLength - kGateMetres - (joined_ ? 0 : kJoinMetres), 0);
}

bool LandingPilot::entersFinal(const Snapshot& now) {
  const AircraftSnapshot& craft = now.aircraft;
  const glm::dvec2 here(craft.position.x, craft.position.z), at = strip_.local(here);
  const glm::dvec2 way = gate() - here;
  if (!joined_) {
    joined_ = way.x * way.x + way.y * way.y < kJoinRadius * kJoinRadius;
    return false;
  }
  const bool isNear = way.x * way.x + way.y * way.y < kGateRadius * kGateRadius;
  const double before = -strip_.halfLength - at.x;
  const bool isBefore =
      before > 0.5 * kGateMetres && before < kGateMetres + kGateRadius && std::abs(at.y) < kGateRadius;
  const double off = wrappedAngle(trackOf(craft.velocity) - strip_.headingRad());
  if (!(isNear || isBefore) || std::abs(off) > kGateAheadRad) return false;
  const double over = craft.position.y - strip_.heightAt(-strip_.halfLength);
  if (over > kSteepestFinal * (before + kAimMetres)) {  // ground before it kept the aircraft too high
    if (strip_.bothWays) strip_ = strip_.reversed();
    joined_ = false;
    return false;
  }
  phase_ = Phase::final;
  flares_ = false;
  return true;
}

Controls LandingPilot::decide(const Snapshot& now) {
  switch (phase_) {
    case Phase::final:
      return flyFinal(now);
    case Phase::rollOut:
      return rollOut(now);
    case Phase::turnRound:
      return turnRound(now);
    case Phase::takeOff:
      return takeOff(now);
    case Phase::away:
    case Phase::approach:
      break;
  }
  return {};
}

Controls LandingPilot::flyFinal(const Snapshot& now) {
  Controls out;
  const AircraftSnapshot& craft = now.aircraft;
  if (craft.gear.wheelsDown > 0 && flares_) {
    phase_ = Phase::rollOut;
    return rollOut(now);
  }
  const glm::dvec2 at = strip_.local({craft.position.x, craft.position.z});
  const double toAim = -strip_.halfLength + kAimMetres - at.x;
  const double wheels = craft.position.y - kWheelHeight;
  const double overStrip = wheels - strip_.heightAt(std::clamp(at.x, -strip_.halfLength, strip_.halfLength));
  const double overPath = overStrip - kFinalSlope * std::max(toAim, 0.0);
  if ((toAim < 0 && (std::abs(at.y) > kMostAside || overStrip > kMostHigh)) ||
      at.x > 0.5 * strip_.halfLength ||
      (!flares_ && overStrip < kDecisionHeight && !isCalmEnough(strip_, now))) {
    phase_ = Phase::takeOff;  // and round again
    return takeOff(now);
  }
  const double level =
      std::max(std::sqrt(craft.velocity.x * craft.velocity.x + craft.velocity.z * craft.velocity.z), 15.0);
  // Across: a track that closes on the middle, by bank.
  const double closing = std::clamp(-at.y / 120, -0.5, 0.5);
  const double turn = wrappedAngle(strip_.headingRad() + closing - trackOf(craft.velocity));
  double bank = std::clamp(1.6 * turn, -0.45, 0.45);
  double climb = std::clamp(-kFinalSlope - overPath / 150, -0.14, 0.05);
  flares_ = flares_ || (overStrip < kFlareHeight && toAim < 150);
  if (flares_) {
    // Sinks slower the lower it is, wings nearly level; the rudder lays the nose along the strip at the end.
    const double sink = std::min(0.4 + 0.35 * std::max(overStrip, 0.0), 2.2);
    climb = strip_.slope - sink / level;
    holdSpeed(out, craft.airspeedMps, overStrip < 5 ? 0 : 35);
    if (-craft.velocity.y > sink + kSinksTooFast) out.thrust = kCatchThrust, out.brake = 0;
    const double off = wrappedAngle(strip_.headingRad() - craft.headingRad);
    if (overStrip < 2) out.yaw = std::clamp(3 * off + 0.5 * craft.angularVelocityBody.y, -1.0, 1.0);
    bank = std::clamp(bank, -0.12, 0.12);
  } else {
    holdSpeed(out, craft.airspeedMps, kFinalSpeed + gustMargin(now));
  }
  hold(out, craft, climb, bank);
  return out;
}

double LandingPilot::steer(const Snapshot& now) const {
  const AircraftSnapshot& craft = now.aircraft;
  const glm::dvec2 at = strip_.local({craft.position.x, craft.position.z});
  const double wanted = strip_.headingRad() - std::clamp(at.y / 40, -0.2, 0.2);
  const double off = wrappedAngle(wanted - craft.headingRad);
  return std::clamp(2.5 * off + 0.9 * craft.angularVelocityBody.y, -1.0, 1.0);
}

Controls LandingPilot::rollOut(const Snapshot& now) {
  Controls out;
  const AircraftSnapshot& craft = now.aircraft;
  out.brake = 1;
  out.yaw = steer(now);
  out.roll = std::clamp(-2.5 * craft.bankRad, -0.5, 0.5);
  if (craft.gear.wheelsDown == 0) {  // a bounce
    const glm::dvec2 at = strip_.local({craft.position.x, craft.position.z});
    if (at.x > 0.3 * strip_.halfLength && craft.airspeedMps > 31) {
      phase_ = Phase::takeOff;  // and round again
      return takeOff(now);
    }
    hold(out, craft, strip_.slope - 0.9 / std::max(craft.airspeedMps, 15.0), 0);
    return out;
  }
  // The tail comes down as the wing lets go.
  if (craft.airspeedMps < 28) out.pitch = 0.5;
  stoppedSteps_ = craft.gear.groundSpeedMps < 0.3 ? stoppedSteps_ + 1 : 0;
  if (stoppedSteps_ > stepsOf(kStopSeconds)) {
    const terrain::Strip strip = strip_;
    beginTakeOff(strip, now);
  }
  return out;
}

Controls LandingPilot::turnRound(const Snapshot& now) {
  Controls out;
  const AircraftSnapshot& craft = now.aircraft;
  const double off = wrappedAngle(strip_.headingRad() - craft.headingRad);
  // On the spot, at walking pace, away from the nearer edge.
  const glm::dvec2 at = strip_.local({craft.position.x, craft.position.z});
  const double way = std::abs(off) > 2.2 ? (at.y > 0 ? 1.0 : -1.0) : (off > 0 ? 1.0 : -1.0);
  out.yaw = std::abs(off) > 0.3 ? way : std::clamp(3 * off, -1.0, 1.0);
  const double speed = craft.gear.groundSpeedMps;
  out.thrust = speed < 2.5 ? 0.18 : 0;
  out.brake = speed > 4 ? 0.5 : 0;
  if (std::abs(off) < 0.12) phase_ = Phase::takeOff;
  return out;
}

Controls LandingPilot::takeOff(const Snapshot& now) {
  Controls out;
  const AircraftSnapshot& craft = now.aircraft;
  out.thrust = 1;
  if (craft.gear.wheelsDown > 0) {
    out.yaw = steer(now);
    out.roll = std::clamp(-2.5 * craft.bankRad, -0.5, 0.5);
    if (craft.airspeedMps > kRotateSpeed) hold(out, craft, kClimbRad, 0);
    return out;
  }
  hold(out, craft, craft.airspeedMps > kRotateSpeed ? kClimbRad : 0.02, 0);
  if (craft.heightAboveGround > kAwayHeight) phase_ = Phase::away;
  return out;
}

}  // namespace skydrop::game
