// The knobs of a cloud layer: the thesis's seven weather parameters in SI units, and what an artist needs
// besides.
#pragma once

#include "skydrop/core/settings.h"

namespace skydrop::clouds {

struct CloudSettings {
  double densityThreshold = 0.534;
  double scale = 0.595;
  double anisotropy = 0.119;
  double extinction = 0.08;
  double higherScale = 20;
  double weatherScale = 0.02;
  double cloudHeight = 1555;

  double thickness = 1800;
  double coverage = 0.5;
  double typeShift = 0;
  double erosion = 0.35;
  double fadeDistance = 24000;

  double windSpeed = 8;
  double windDirection = 250;
};

void describe(core::SettingsVisitor& visitor, CloudSettings& settings);

// Sides of the periods with which the noise textures repeat, metres. The weather map's is at least twice the
// distance at which clouds have faded out.
double shapePeriod(const CloudSettings& settings);
double detailPeriod(const CloudSettings& settings);
double weatherPeriod(const CloudSettings& settings);

}  // namespace skydrop::clouds
