// The tuned numbers of the aircraft. The first seven are the thesis's (3.5.9 and its program), with its
// defaults, on a body of mass 1 and inertia 3 in its units; airplane.h tells how they become newtons and
// newton metres. Plain values; describe() states and enforces the ranges at every entry (files, --set, the
// menu).
#pragma once

#include "skydrop/core/settings.h"
#include "skydrop/flight/integrator.h"

namespace skydrop::flight {

struct AirplaneSettings {
  double rollFactor = 0.75;         // 1, 0 .. 3: weight of the control in the roll torque
  double stabilizingRoll = 0.5;     // 1, 0 .. 3: weight of the stabiliser in it
  double pitchSpeed = 20;           // the thesis's torque, 0 .. 60, of control and stabiliser
  double yawSpeed = 32.175;         // the thesis's torque, 0 .. 100, of control and bank
  double rollSpeed = 32.175;        // the thesis's torque, 0 .. 100, of control and stabiliser
  double maxThrottle = 198;         // the thesis's force (50.139 N), 0 .. 1000, at full throttle
  double inducedYawFactor = 0.055;  // 1, 0 .. 1: yaw into the bank

  double pitchFade = 0.5;  // 1, 0 .. 1: share of the thesis's 1 - abs(sine of pitch) in the pitch torque
  double stabilizingPitch = 0.65;   // 1, 0 .. 3: weight of the stabiliser in the pitch torque
  double inducedPitchFactor = 0.1;  // the thesis's torque, 0 .. 10, nose down in a bank
  double mass = 1200;               // kg, 200 .. 10000
  double cruiseSpeed = 70;          // m/s, 40 .. 110
  double throttleRate = 0.7;        // 1/s, 0.05 .. 10
  double rollDamping = 9;           // 1/s, 0.5 .. 60
  double pitchDamping = 4;          // 1/s, 0 .. 60
  double yawDamping = 8;            // 1/s, 0 .. 60
  double pitchStiffness = 28;       // rad/s^2 per rad at 70 m/s, 0 .. 400
  double yawStiffness = 60;         // rad/s^2 per rad at 70 m/s, 0 .. 400
  double wingArea = 16;             // m^2, 4 .. 80
  double liftSlope = 5;             // per rad, 1 .. 8
  double stallAngleDeg = 16;        // degrees, 5 .. 30
  double stallWarning = 0.85;       // of the stall angle, 0.5 .. 1
  double stallLiftLoss = 0.4;       // of the lift, 0 .. 0.9
  double stallNoseDrop = 8;         // rad/s^2 at 70 m/s, 0 .. 60
  double dragCoefficient = 0.07;    // 1, 0.005 .. 0.5: the linear damping of the body
  double inducedDrag = 0.05;        // 1, 0 .. 0.5
  double sideForceSlope = 1;        // per rad, 0 .. 5
  Integrator integrator = Integrator::rk4;
};

void describe(core::SettingsVisitor& visitor, AirplaneSettings& settings);

}  // namespace skydrop::flight
