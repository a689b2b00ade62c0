// The tuned numbers of the package and its parachute.
#pragma once

#include "skydrop/core/settings.h"

namespace skydrop::flight {

struct PackageSettings {
  double mass = 60;               // kg
  double size = 0.8;              // m, edge of the box
  double freeFallSpeed = 60;      // m/s, terminal speed before the parachute opens
  double parachuteSpeed = 8;      // m/s, terminal speed under the open parachute
  double parachuteDelay = 1;      // s after the release
  double parachuteOpening = 0.8;  // s from closed to open
};

void describe(core::SettingsVisitor& visitor, PackageSettings& settings);

}  // namespace skydrop::flight
