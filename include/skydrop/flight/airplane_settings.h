// The tuned numbers of the aircraft. The first seven are the thesis's (3.5.9 and its program), with its
// defaults, on a body of mass 1 and inertia 3 in its units; airplane.h tells how they become newtons and
// newton metres.
#pragma once

#include "skydrop/core/settings.h"
#include "skydrop/flight/integrator.h"

namespace skydrop::flight {

struct AirplaneSettings {
  double rollFactor = 0.75;
  double stabilizingRoll = 0.5;
  double pitchSpeed = 20;
  double yawSpeed = 32.175;
  double rollSpeed = 32.175;
  double maxThrottle = 198;
  double inducedYawFactor = 0.055;

  double pitchFade = 0.5;           // 1: share of the thesis's 1 - abs(sine of pitch) in the pitch torque
  double stabilizingPitch = 0.65;   // 1
  double inducedPitchFactor = 0.1;  // 1
  double mass = 1200;               // kg
  double cruiseSpeed = 70;          // m/s
  double throttleRate = 0.7;        // 1/s
  double rollDamping = 9;           // 1/s
  double pitchDamping = 4;          // 1/s
  double yawDamping = 8;            // 1/s
  double pitchStiffness = 28;       // rad/s^2 per rad at 70 m/s
  double yawStiffness = 60;         // rad/s^2 per rad at 70 m/s
  double wingArea = 16;             // m^2
  double liftSlope = 5;             // per rad
  double stallAngleDeg = 16;        // degrees
  double stallWarning = 0.85;       // of the stall angle
  double stallLiftLoss = 0.4;       // of the lift
  double stallNoseDrop = 8;         // rad/s^2 at 70 m/s
  double dragCoefficient = 0.07;    // 1: the linear damping of the body
  double inducedDrag = 0.05;        // 1
  double sideForceSlope = 1;        // per rad
  Integrator integrator = Integrator::rk4;
};

void describe(core::SettingsVisitor& visitor, AirplaneSettings& settings);

}  // namespace skydrop::flight
