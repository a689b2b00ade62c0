// The tuned numbers of the landing gear: its springs and tyres, what it stands, what the water stands. Plain
// values; describe() states and enforces the ranges at every entry (files, --set, the menu).
#pragma once

#include "skydrop/core/settings.h"

namespace skydrop::flight {

struct GearSettings {
  double stiffness = 60000;      // N/m, 20 000 .. 400 000, of a main wheel; the tail wheel has half of it
  double damping = 0.7;          // s/m, 0 .. 3: share of the spring's force for each m/s of compression
  double friction = 0.7;         // 1, 0.1 .. 1.5, of a tyre that slides
  double rollingResistance = 1;  // factor, 0 .. 5, on that of the ground
  double brakeFriction = 0.4;    // 1, 0 .. 1: share of a main wheel's load that full brakes hold
  double steeringDeg = 30;       // degrees, 0 .. 60, of the tail wheel at rest
  double steeringSpeed = 8;      // m/s, 1 .. 60: where half of it is left
  double groundRoughness = 1;    // factor, 0 .. 5, on the bumps of the ground

  double mostSinkRate = 4;     // m/s, 0.5 .. 20: faster on the wheels breaks the gear
  double mostSideLoad = 1.2;   // weights, 0.1 .. 10: more across the wheels breaks the gear
  double mostSlopeDeg = 15;    // degrees, 1 .. 60: steeper ground breaks it where it is met faster than 5 m/s
  double mostStrikeSpeed = 6;  // m/s, 0 .. 60: hull, wing or tail on the ground faster than that break
  double mostWaterSink = 4;    // m/s, 0.5 .. 20: the hull breaks on water that it meets faster
  double mostWaterSpeed = 50;  // m/s, 5 .. 120: or when it is faster than that along the water
  double floatSeconds = 6;     // s, 0.5 .. 60, from ditching to the end of the flight
};

void describe(core::SettingsVisitor& visitor, GearSettings& settings);

}  // namespace skydrop::flight
