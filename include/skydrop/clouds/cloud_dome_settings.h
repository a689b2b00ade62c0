// Clouds on a hemisphere at infinity, cut out of a volume of noise. A value; any thread.
// Source: Tarantilis, "Simulating clouds with procedural texturing techniques using the GPU", 2004, chapters
// III and IV.
#pragma once

#include <cstdint>

#include "skydrop/clouds/sheet_resolution.h"
#include "skydrop/core/settings.h"

namespace skydrop::clouds {

struct CloudDomeSettings {
  double scale = 0.4;       // copies of the volume across the unit dome's radius, [0.05, 4]
  double cutoff = 0.61;     // noise up to it is no cloud, [0, 1]; from 1 on the dome is empty
  double exponent = 0.96;   // light that 1 / 255 of noise above the cutoff lets through, [0.8, 0.999]
  double bias = 1;          // factor of the opacity, [0, 1]; 0: an empty dome
  double speedX = 0.0015;   // drift: copies of the volume a second, [-0.1, 0.1]
  double speedY = 0.0005;   // formation: likewise, across the layer, [-0.1, 0.1]
  double flatness = 1;      // 0: the noise lies on a hemisphere, 1: on a level sheet seen from below, [0, 1]
  double selfShadow = 1.5;  // optical depth towards the sun as a multiple of that seen, [0, 8]
  double red = 1, green = 1, blue = 1;  // colour of the clouds, linear, [0, 1]
  SheetResolution resolution = SheetResolution::full;
  std::int64_t octaves = 6;        // of the noise, [1, 8]
  std::int64_t frequency = 6;      // lattice cells across the volume of the first octave, [1, 32]
  double amplitude = 0.7;          // of the first octave, [0.1, 2]
  double persistence = 0.5;        // amplitude of an octave as a share of the one before, [0.1, 0.9]
  std::int64_t textureSide = 128;  // texels of the volume, a power of two, [32, 256]
  std::int64_t seed = 4;           // of the noise, [0, 65535]

  bool operator==(const CloudDomeSettings&) const = default;
};

// Whether two domes are made of the same noise.
bool isSameNoise(const CloudDomeSettings& a, const CloudDomeSettings& b);

void describe(core::SettingsVisitor& visitor, CloudDomeSettings& settings);

}  // namespace skydrop::clouds
