// The lamps that the aircraft carries. Values; any thread.
#pragma once

#include "skydrop/core/settings.h"

namespace skydrop::render {

struct AircraftLightsSettings {
  double brightness = 1;         // times the intensities that airworthiness asks for, 0 .. 4
  double flashesPerMinute = 48;  // of the anti-collision lights, 40 .. 100
  bool strobes = true;           // the white flashes at the wing tips
  double cabinBrightness = 1;    // of the lamp over the instruments, 0 .. 4

  bool operator==(const AircraftLightsSettings&) const = default;
};

struct LandingLightSettings {
  bool on = false;
  double intensity = 250000;  // on the beam's axis, cd, 1e3 .. 1e6
  double beamDegrees = 14;    // across, to half the intensity, 3 .. 40
  double tiltDegrees = 10;    // of the axis below the nose, 0 .. 30

  bool operator==(const LandingLightSettings&) const = default;
};

void describe(core::SettingsVisitor& visitor, AircraftLightsSettings& settings);
void describe(core::SettingsVisitor& visitor, LandingLightSettings& settings);

}  // namespace skydrop::render
