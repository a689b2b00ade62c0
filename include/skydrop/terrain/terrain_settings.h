// The knobs of the land. Sea level is height 0 by definition; the settings move the land against it.
#pragma once

#include <cstdint>

#include "skydrop/core/settings.h"

namespace skydrop::terrain {

// All wavelengths are the sides of lattice cells, metres, and are rounded to a power of two: a full wave of
// the noise is about 1.7 of them. The defaults are what the program ships with.
struct TerrainSettings {
  double continentWavelength = 32768;
  double landBias = 0.16;
  double seaDepth = 200;
  double plainHeight = 260;

  double rangeWavelength = 16384;
  double rangeShare = 0.5;
  double mountainHeight = 1280;
  double mountainWavelength = 4096;

  double valleyWavelength = 8192;
  double valleyWidth = 0.16;

  double roughness = 1.0;
  double plainRoughness = 1.0;
  double finestWavelength = 16;
};

void describe(core::SettingsVisitor& visitor, TerrainSettings& settings);

}  // namespace skydrop::terrain
