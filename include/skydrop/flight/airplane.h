// The aircraft: a rigid body pushed by thrust, control torques, stabilising and induced torques after the
// thesis (R. A. Bhatia, 3.5.9, equations 3.7 to 3.14), and by lift, side force, drag and the pull of the
// airflow on its tail, so that the flight path follows the nose. docs/flight.md tells the balance and how the
// thesis's numbers became SI. Not thread-safe, deterministic.
#pragma once

#include <glm/vec3.hpp>

#include "skydrop/flight/airplane_settings.h"
#include "skydrop/flight/landing_gear.h"
#include "skydrop/flight/rigid_body.h"

namespace skydrop::flight {

// The thesis's torques act on an inertia of 3 of its units: one unit of torque is 1/3 rad/s^2 of angular
// acceleration. Here too, about each axis, whatever the inertia in kg m^2.
inline constexpr double kThesisInertia = 3;
// Newtons per unit of maxThrottle: with the default 198 full thrust equals the drag of level flight at 120
// m/s.
inline constexpr double kNewtonsPerThrottleUnit = 50.139;
// From this separation on the aircraft counts as stalled: less than a tenth of a second after the flow
// leaves.
inline constexpr double kStalledSeparation = 0.3;

// A step on the ground is made in so many parts (docs/ground-handling.md has the error of others).
inline constexpr int kGearParts = 4;

struct AirplaneInput {
  double thrust = 0;   // 0..1
  double brake = 0;    // 0..1
  double pitch = 0;    // -1..1, nose up positive
  double roll = 0;     // -1..1, right wing down positive
  double yaw = 0;      // -1..1, nose right positive
  bool idles = false;  // the throttle rests at idle, not at cruise
};

// How the air meets the aircraft.
struct Airflow {
  double airspeed = 0;         // m/s
  double angleOfAttack = 0;    // rad, air from below positive, (-pi, pi]; 0 without airspeed
  double sideslip = 0;         // rad, flight path right of the nose positive, [-pi/2, pi/2]
  double liftCoefficient = 0;  // 1
  double loadFactor = 0;       // lift over weight, along the body's up axis
  double stallShare = 0;       // angle of attack, trim included, over the stall angle; >= 0
};

// What of the aircraft moves slower than a step but is no part of the body's motion.
struct AirplaneCondition {
  double throttle = 0;    // 0 idle .. 1 full
  double separation = 0;  // of the flow from the wing: 0 attached .. 1 stalled
  double borne = 0;       // share of the weight that wheels bear, 0 .. 1
};

// The air that meets the aircraft during a step. A wind alone converts to it: air of the sea's level that
// moves.
struct AirMass {
  AirMass() = default;
  AirMass(const glm::dvec3& velocity) : wind(velocity) {}  // NOLINT: the common case

  glm::dvec3 wind{0};       // its velocity, m/s, world axes
  double densityShare = 1;  // of kAirDensity: forces of wing, tail, drag and engine scale with it
  double liftShare = 1;     // of the wing's lift that ice has left
  double dragShare = 1;     // of the drag, with ice more than 1
};

// The forces of one moment: a pure function of the state, evaluated several times within a step. Finite for
// every finite state; the aerodynamic part goes to zero continuously with the airspeed.
Wrench airplaneWrench(const AirplaneSettings& settings, const MassProperties& body,
                      const AirplaneInput& input, const AirplaneCondition& condition, const AirMass& air,
                      const BodyState& state);

Airflow airflowOf(const AirplaneSettings& settings, double separation, const AirMass& air,
                  const BodyState& state);

// The throttle at which level flight at cruise speed is steady, in [0, 1].
double cruiseThrottle(const AirplaneSettings& settings);

class Airplane {
 public:
  // Throws core::RangeError when the settings or the state are unusable. Starts at cruise throttle.
  Airplane(const AirplaneSettings& settings, const BodyState& start);

  // Advances by dt seconds in this air. dt <= 0 or not finite changes nothing.
  void step(const AirplaneInput& input, const AirMass& air, double dt);

  // The same where its gear may touch: in kGearParts parts, each with the ground asked again.
  void stepOnGround(const AirplaneInput& input, const AirMass& air, double dt, LandingGear& gear,
                    const GearInput& wheels, const GroundField& ground);

  const RigidBody& body() const { return body_; }
  double throttle() const { return condition_.throttle; }  // 0 idle .. 1 full
  // 0 attached .. 1 stalled: grows within a tenth of a second past the stall angle, and heals within a
  // second.
  double separation() const { return condition_.separation; }
  const AirplaneSettings& settings() const { return settings_; }

  // Places it again, at cruise throttle and with attached flow. Throws core::RangeError, and changes nothing,
  // unless finite.
  void place(const BodyState& state);
  void setThrottle(double throttle) { condition_.throttle = throttle; }  // 0 .. 1
  // The same state, bit for bit, under other numbers. Throws core::RangeError, and changes nothing, when they
  // are unusable.
  void apply(const AirplaneSettings& settings);

 private:
  // Moves it towards what is asked, and returns what acts meanwhile.
  AirplaneCondition moveThrottle(const AirplaneInput& input, double dt);
  void separate(const AirMass& air, double dt);

  AirplaneSettings settings_;
  RigidBody body_;
  AirplaneCondition condition_;
};

}  // namespace skydrop::flight
