// The tuned numbers of the package and its parachute. Plain values; describe() states and enforces the ranges
// at every entry (files, --set, the menu). A struct that is filled by hand is checked by flight::Package.
#pragma once

#include "skydrop/core/settings.h"

namespace skydrop::flight {

struct PackageSettings {
  double mass = 60;               // kg, 1 .. 2000
  double size = 0.8;              // m, 0.1 .. 5, edge of the box
  double freeFallSpeed = 60;      // m/s, 10 .. 300, terminal speed before the parachute opens
  double parachuteSpeed = 8;      // m/s, 1 .. 60, terminal speed under the open parachute
  double parachuteDelay = 1;      // s after the release, 0 .. 30
  double parachuteOpening = 0.8;  // s from closed to open, 0 .. 10
};

void describe(core::SettingsVisitor& visitor, PackageSettings& settings);

}  // namespace skydrop::flight
