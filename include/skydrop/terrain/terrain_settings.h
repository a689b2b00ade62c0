// The shape of the procedural land. Sea level is height 0 by definition; the settings move the land against
// it. Plain values: any thread may copy them. Ranges are those that describe() states and enforces at every
// entry (files, --set, the menu); a struct that is filled by hand is not checked. A change gives another
// world: everything that was made of the old one (chunks, targets, a recorded flight) is void.
#pragma once

#include <cstdint>

#include "skydrop/core/settings.h"

namespace skydrop::terrain {

// All wavelengths are the sides of lattice cells, metres, and are rounded to a power of two: a full wave of
// the noise is about 1.7 of them. The defaults are what the program ships with.
struct TerrainSettings {
  double continentWavelength = 32768;  // m, 8192 .. 131072
  double landBias = 0.16;              // added to the continents' noise, -1 .. 1; more leaves less sea
  double seaDepth = 200;               // m, 20 .. 240, far from land
  double plainHeight = 260;            // m above the sea, 0 .. 600, far from it

  double rangeWavelength = 16384;    // m, 4096 .. 65536: spaces the mountain ranges
  double rangeShare = 0.5;           // of the land, 0 .. 1
  double mountainHeight = 1280;      // m above the plains, 0 .. 1500, of the highest peaks
  double mountainWavelength = 4096;  // m, 1024 .. 16384: of hills and ridges

  double valleyWavelength = 8192;  // m, 2048 .. 32768: spaces rivers and passes
  double valleyWidth = 0.16;       // share of their noise, .01 .. 1

  double roughness = 1.0;        // factor, 0 .. 2, on erosion and on the small relief of mountains
  double plainRoughness = 1.0;   // factor, 0 .. 2, on hills and the small relief of plains
  double finestWavelength = 16;  // m, 16 .. 512: the smallest octave; each one less costs time
};

void describe(core::SettingsVisitor& visitor, TerrainSettings& settings);

}  // namespace skydrop::terrain
