#include "skydrop/flight/airplane.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "skydrop/core/deterministic_math.h"
#include "skydrop/core/error.h"
#include "skydrop/flight/environment.h"

namespace skydrop::flight {

namespace dmath = core::dmath;

namespace {

// Radii of gyration about pitch (x), yaw (y) and roll (z) of a light single-engine aircraft, m: those of the
// Cessna 172 (inertia 1825, 2667, 1285 kg m^2 at 1043 kg; Roskam 1979). They matter for the gyroscopic term
// only.
constexpr glm::dvec3 kGyration{1.323, 1.599, 1.110};
// The stiffness settings are stated at this airspeed; like all air forces they grow with its square.
constexpr double kStiffnessSpeed = 70;
// Roll, yaw and the stabilisers act fully from here on, and with the square of the airspeed below: a little
// above the stall, so that a hanging aircraft cannot turn in place.
constexpr double kFullControlSpeed = 35;
// The elevator likewise: so that a full pull reaches the same angle of attack at all lower speeds, where the
// tail's stiffness shrinks alike, and stalls only when the trim itself needs much of the wing.
constexpr double kFullElevatorSpeed = kStiffnessSpeed;
// Share of the greatest lift that the trim uses up: the rest is left for the pilot.
constexpr double kTrimShare = 0.8;
// Bank up to which the trim carries the aircraft through a level turn: cosine of 60 degrees.
constexpr double kTrimmedBankCosine = 0.5;
// Below this airspeed the path's own turning rate loses its meaning and fades out, m/s.
constexpr double kPathRateSpeed = 10;
// On the back the sine of the bank vanishes and nothing would right the aircraft: this much of full
// stabilising is added there, towards the side that already hangs lower (the right one when neither does).
constexpr double kRightingSine = 0.2;
// The nose grows heavy over this band of the stall angle, before and past it: hands off a glide settles in
// it.
constexpr double kHeavyNoseFrom = 0.85, kHeavyNoseTo = 1.1;
// The flow separates over this band of the stall angle, and takes so long for it and for its return, s. The
// difference is what makes a stall a break and not a plateau.
constexpr double kSeparatesFrom = 1.0, kSeparatesTo = 1.06;
constexpr double kSeparationSeconds = 0.1, kAttachmentSeconds = 0.7;
// Drag of a flat plate broadside on; scales the drag at large angles of attack and sideslip.
constexpr double kBroadsideDrag = 1;

MassProperties massPropertiesOf(const AirplaneSettings& s) {
  const glm::dvec3 i = s.mass * kGyration * kGyration;
  return {s.mass, glm::dmat3(i.x, 0, 0, 0, i.y, 0, 0, 0, i.z),
          glm::dmat3(1 / i.x, 0, 0, 0, 1 / i.y, 0, 0, 0, 1 / i.z)};
}

double maxThrust(const AirplaneSettings& s) { return s.maxThrottle * kNewtonsPerThrottleUnit; }

// A lift curve with the slope of the wing at small angles and a flat knee at the stall angle: CL / slope as a
// function of x = sin(a) cos(a).
double lifted(double x, double stallAngle) {
  const double r = x / stallAngle, r2 = r * r;
  return x / std::sqrt(std::sqrt(1 + r2 * r2));
}

// 0 below `from`, 1 above `to`, smooth between.
double smoothStep(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

// Share of the air's density that is left at a height: all of it in the world that is meant to be flown in.
double airLeftAt(double height) {
  return height <= kThinAirFrom ? 1 : dmath::exp((kThinAirFrom - height) / kThinAirScale);
}

struct Flow {
  glm::dvec3 velocity{0};  // of the body through the air, body axes
  double speed = 0;
  double liftArgument = 0;  // x of the lift curve, trim included
  double stallShare = 0;    // the same over the stall angle; negative pushed past zero lift
  double liftCoefficient = 0;
};

Flow flowOf(const AirplaneSettings& s, double separation, const AirMass& air, const BodyState& state) {
  Flow f;
  f.velocity = glm::conjugate(state.orientation) * (state.velocity - air.wind);
  f.speed = glm::length(f.velocity);
  const double stallAngle = s.stallAngleDeg * dmath::kRadPerDeg;
  // Trim: with the flow along the nose the wing carries what a level turn at this bank, or a straight climb
  // at this pitch, needs. l = cos^2 pitch, c = cos pitch cos bank; l / c is 1 / cos bank in a level turn and
  // cos pitch in a straight climb; past 60 degrees it fades, to nothing on the back.
  const glm::dvec3 forward = state.orientation * glm::dvec3(0, 0, -1),
                   up = state.orientation * glm::dvec3(0, 1, 0);
  const double l = 1 - forward.y * forward.y, c = up.y;
  const double wanted =
      l * (c >= kTrimmedBankCosine ? 1 / c : (c + 1) / ((1 + kTrimmedBankCosine) * kTrimmedBankCosine));
  const double pressureArea =
      0.5 * kAirDensity * f.speed * f.speed * s.wingArea * air.densityShare;  // N per unit of coefficient
  const double most = kTrimShare * stallAngle;
  const double weight = s.mass * kGravity;
  const double trim = wanted * weight < most * s.liftSlope * pressureArea
                          ? std::max(wanted * weight / (s.liftSlope * pressureArea), 0.0)
                          : most;
  const double t = trim / stallAngle, t2 = t * t;
  const double trimArgument = trim / std::sqrt(std::sqrt(1 - t2 * t2));  // the inverse of lifted()
  // sin a cos a from the velocity itself; the small term only keeps 0/0 away, all of it is multiplied by the
  // square of the speed.
  const double inPlane = f.velocity.y * f.velocity.y + f.velocity.z * f.velocity.z;
  f.liftArgument = f.velocity.y * f.velocity.z / (inPlane + 1e-12) + trimArgument;
  f.stallShare = f.liftArgument / stallAngle;
  f.liftCoefficient =
      s.liftSlope * lifted(f.liftArgument, stallAngle) * (1 - s.stallLiftLoss * separation) * air.liftShare;
  return f;
}

void requireUsable(const AirplaneSettings& s) {
  for (const double positive :
       {s.mass, s.wingArea, s.liftSlope, s.stallAngleDeg, s.cruiseSpeed, s.throttleRate}) {
    if (!std::isfinite(positive) || positive <= 0) {
      throw core::RangeError(
          "airplane: mass, wingArea, liftSlope, stallAngleDeg, cruiseSpeed and throttleRate must be "
          "positive and finite");
    }
  }
  for (const double any :
       {s.rollFactor,   s.stabilizingRoll,  s.pitchSpeed,       s.yawSpeed,           s.rollSpeed,
        s.maxThrottle,  s.inducedYawFactor, s.stabilizingPitch, s.inducedPitchFactor, s.rollDamping,
        s.pitchDamping, s.yawDamping,       s.pitchStiffness,   s.yawStiffness,       s.dragCoefficient,
        s.inducedDrag,  s.sideForceSlope,   s.pitchFade,        s.stallWarning,       s.stallLiftLoss,
        s.stallNoseDrop}) {
    if (!std::isfinite(any)) throw core::RangeError("airplane: a setting is not finite");
  }
}

RigidBody makeBody(const AirplaneSettings& s, const BodyState& start) {
  requireUsable(s);
  RigidBody body(s.mass, start.position, start.orientation, massPropertiesOf(s).inertia);
  body.setState(start);
  body.setIntegrator(s.integrator);
  return body;
}

}  // namespace

Wrench airplaneWrench(const AirplaneSettings& s, const MassProperties& body, const AirplaneInput& input,
                      const AirplaneCondition& condition, const AirMass& air, const BodyState& state) {
  const Flow f = flowOf(s, condition.separation, air, state);
  const glm::dvec3& v = f.velocity;
  const double left = airLeftAt(state.position.y) * air.densityShare;
  const double halfDensityArea = 0.5 * kAirDensity * s.wingArea * left;

  // Forces in body axes. None divides by the speed: each is built from speed times a component of the
  // velocity.
  const double cl = f.liftCoefficient;
  const glm::dvec3 lift = halfDensityArea * cl * f.speed * glm::cross(glm::dvec3(1, 0, 0), v);
  const glm::dvec3 side{-halfDensityArea * s.sideForceSlope * f.speed * v.x, 0, 0};
  const double inverseSquare = 1 / (f.speed * f.speed + 1e-12);
  const double dragCoefficient =
      s.dragCoefficient + s.inducedDrag * cl * cl + kBroadsideDrag * (v.x * v.x + v.y * v.y) * inverseSquare;
  const glm::dvec3 drag = -halfDensityArea * dragCoefficient * air.dragShare * f.speed * v;
  const glm::dvec3 thrust{0, 0, -condition.throttle * maxThrust(s) * left};  // (3.7)
  Wrench w;
  w.force = state.orientation * (lift + side + drag + thrust) - glm::dvec3(0, body.mass * kGravity, 0);

  // Angular accelerations about the body's axes. Angles enter by their sines: equal for small angles, and
  // smooth at every attitude where an angle jumps.
  const glm::dvec3 forward = state.orientation * glm::dvec3(0, 0, -1),
                   right = state.orientation * glm::dvec3(1, 0, 0),
                   up = state.orientation * glm::dvec3(0, 1, 0);
  const double sinePitch = std::clamp(forward.y, -1.0, 1.0), sineBank = -right.y;
  const auto authority = [&](double fullSpeed) {
    return std::min(f.speed * f.speed / (fullSpeed * fullSpeed) * air.densityShare, 1.0) / kThesisInertia;
  };
  const double pitchUp = s.pitchSpeed * input.pitch * (1 - s.pitchFade * std::abs(sinePitch))  // (3.8)
                         - s.inducedPitchFactor * std::abs(sineBank);                          // (3.14)
  const double righting = sineBank + std::copysign(kRightingSine * std::max(-up.y, 0.0), sineBank);
  const double rollRight = s.rollSpeed * (s.rollFactor * input.roll         // (3.9)
                                          - s.stabilizingRoll * righting);  // (3.11)
  const double yawRight = s.yawSpeed * (input.yaw                           // (3.10)
                                        + s.inducedYawFactor * sineBank);   // (3.13)
  // (3.12) about the level axis across the nose, so that it lifts the nose and does not swing it when banked.
  const glm::dvec3 levelAxis = glm::conjugate(state.orientation) * glm::cross(forward, glm::dvec3(0, 1, 0));
  const glm::dvec3 stabilising = -s.stabilizingPitch * s.pitchSpeed * sinePitch * levelAxis;
  glm::dvec3 acceleration =
      authority(kFullControlSpeed) * (glm::dvec3(0, -yawRight, -rollRight) + stabilising);
  acceleration.x += authority(kFullElevatorSpeed) * pitchUp;

  // The tail turns the nose into the airflow.
  const double stiff = f.speed / (kStiffnessSpeed * kStiffnessSpeed) * air.densityShare;
  acceleration.x += s.pitchStiffness * stiff * v.y;
  acceleration.y -= s.yawStiffness * stiff * v.x;

  // Near the stall the nose grows heavy, and where the flow has separated it drops.
  const double heavy = smoothStep(kHeavyNoseFrom, kHeavyNoseTo, std::abs(f.stallShare));
  acceleration.x -= std::copysign(s.stallNoseDrop * (0.4 * heavy + condition.separation), f.stallShare) *
                    std::min(f.speed * stiff, 1.0) * (1 - condition.borne);

  // Damping of pitch and yaw is towards the rate at which the flight path itself turns: a turning aircraft is
  // not held back. Roll has no such rate.
  const glm::dvec3 pathRate =
      glm::conjugate(state.orientation) * (glm::cross(state.velocity - air.wind, w.force / body.mass) /
                                           (f.speed * f.speed + kPathRateSpeed * kPathRateSpeed));
  // On its wheels it has none that the air does not give, or it could not turn on the spot.
  const glm::dvec3& spin = state.angularVelocity;
  const double free =
      1 - condition.borne * (1 - std::min(f.speed * f.speed / (kFullControlSpeed * kFullControlSpeed), 1.0));
  acceleration -= glm::dvec3(s.pitchDamping * (spin.x - pathRate.x),
                             s.yawDamping * free * (spin.y - pathRate.y), s.rollDamping * spin.z);
  w.torque = body.inertia * acceleration;
  return w;
}

Airflow airflowOf(const AirplaneSettings& s, double separation, const AirMass& air, const BodyState& state) {
  const Flow f = flowOf(s, separation, air, state);
  Airflow out;
  out.airspeed = f.speed;
  out.angleOfAttack = f.speed > 0 ? dmath::atan2(-f.velocity.y, -f.velocity.z) : 0;
  out.sideslip = dmath::atan2(f.velocity.x, glm::length(glm::dvec3(0, f.velocity.y, f.velocity.z)));
  out.liftCoefficient = f.liftCoefficient;
  out.loadFactor = 0.5 * kAirDensity * s.wingArea * air.densityShare * f.liftCoefficient * f.speed *
                   -f.velocity.z / (s.mass * kGravity);
  out.stallShare = std::abs(f.stallShare);
  return out;
}

double cruiseThrottle(const AirplaneSettings& s) {
  const double pressureArea = 0.5 * kAirDensity * s.cruiseSpeed * s.cruiseSpeed * s.wingArea;
  const double cl = std::min(s.mass * kGravity / pressureArea,
                             kTrimShare * s.liftSlope * s.stallAngleDeg * dmath::kRadPerDeg);
  const double drag = pressureArea * (s.dragCoefficient + s.inducedDrag * cl * cl);
  return maxThrust(s) > drag ? std::max(drag / maxThrust(s), 0.0) : 1;
}

Airplane::Airplane(const AirplaneSettings& settings, const BodyState& start)
    : settings_(settings), body_(makeBody(settings, start)), condition_{cruiseThrottle(settings), 0} {}

AirplaneCondition Airplane::moveThrottle(const AirplaneInput& input, double dt) {
  const double rest = input.idles ? 0 : cruiseThrottle(settings_);
  const double wanted = std::clamp(rest + input.thrust * (1 - rest) - input.brake * rest, 0.0, 1.0);
  const double reach = settings_.throttleRate * dt;
  AirplaneCondition acting = condition_;
  condition_.throttle += std::clamp(wanted - condition_.throttle, -reach, reach);
  // The mean of a ramp: second order in the step.
  acting.throttle = 0.5 * (acting.throttle + condition_.throttle);
  return acting;
}

void Airplane::step(const AirplaneInput& input, const AirMass& air, double dt) {
  if (!std::isfinite(dt) || dt <= 0) return;
  const AirplaneCondition acting = moveThrottle(input, dt);
  body_.update(dt, [&](const BodyState& at) {
    return airplaneWrench(settings_, body_.properties(), input, acting, air, at);
  });
  separate(air, dt);
}

void Airplane::stepOnGround(const AirplaneInput& input, const AirMass& air, double dt, LandingGear& gear,
                            const GearInput& wheels, const GroundField& ground) {
  if (!std::isfinite(dt) || dt <= 0) return;
  AirplaneCondition acting = moveThrottle(input, dt);
  acting.borne = gear.borne(settings_.mass * kGravity);
  gear.beginStep();
  const double part = dt / kGearParts;
  for (int i = 0; i < kGearParts; ++i) {
    gear.meet(body_.state(), wheels, ground);
    body_.update(part, [&](const BodyState& at, double seconds) {
      Wrench w = airplaneWrench(settings_, body_.properties(), input, acting, air, at);
      const Wrench bears = gear.wrench(at, seconds);
      w.force += bears.force;
      w.torque += bears.torque;
      return w;
    });
    gear.settle(body_.state(), part);
  }
  separate(air, dt);
}

void Airplane::separate(const AirMass& air, double dt) {
  const Flow flow = flowOf(settings_, condition_.separation, air, body_.state());
  const double wantedSeparation = smoothStep(kSeparatesFrom, kSeparatesTo, std::abs(flow.stallShare));
  const double seconds = wantedSeparation > condition_.separation ? kSeparationSeconds : kAttachmentSeconds;
  condition_.separation += (wantedSeparation - condition_.separation) * dt / (seconds + dt);
}

void Airplane::place(const BodyState& state) {
  body_.setState(state);
  condition_ = {cruiseThrottle(settings_), 0};
}

void Airplane::apply(const AirplaneSettings& settings) {
  requireUsable(settings);
  body_.setMass(settings.mass, massPropertiesOf(settings).inertia);
  body_.setIntegrator(settings.integrator);
  settings_ = settings;
}

}  // namespace skydrop::flight
