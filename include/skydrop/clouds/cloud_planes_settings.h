// Clouds as up to three flat layers of noise: what they are made of and how they look. A value; any thread.
// Source: Tarantilis, "Simulating clouds with procedural texturing techniques using the GPU", 2004, chapters
// III and IV, whose three layers are the defaults.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "skydrop/clouds/sheet_resolution.h"
#include "skydrop/core/settings.h"

namespace skydrop::clouds {

inline constexpr std::size_t kCloudPlanes = 3;

struct CloudPlaneSettings {
  std::int64_t octaves = 10;        // of the noise, [1, 10]
  double cutoff = 0.6;              // noise up to it is no cloud, [0, 1]; from 1 on the layer is empty
  std::int64_t frequency = 3;       // lattice cells across the texture of the first octave, [1, 32]
  double amplitude = 0.5;           // of the first octave, [0.1, 2]
  double persistence = 0.7;         // amplitude of an octave as a share of the one before, [0.1, 0.9]
  double density = 0.95;            // light that 1 / 255 of noise above the cutoff lets through, [0.8, 0.999]
  std::int64_t textureSide = 1024;  // texels, a power of two, [64, 2048]
  double height = 1400;             // m above the sea, [100, 12000]
  std::int64_t seed = 1;            // of the noise, [0, 65535]
  double period = 9000;             // m that the texture covers before it repeats, [500, 40000]

  bool operator==(const CloudPlaneSettings&) const = default;
};

struct CloudPlanesSettings {
  std::int64_t count = 3;   // of the layers below that are drawn, the first ones, [0, 3]
  double radiusM = 60000;   // from the eye to the rim, where layers have faded, m, [5000, 200000]
  double variation = 0.7;   // how much cover changes from place to place, [0, 2]; 0: everywhere the same
  double detail = 0.3;      // share of a finer copy of the noise that frays edges, [0, 1]; 0: none
  double selfShadow = 2.5;  // optical depth towards the sun as a multiple of that seen, [0, 8]
  SheetResolution resolution = SheetResolution::full;
  std::array<CloudPlaneSettings, kCloudPlanes> layers = {{
      {.octaves = 10,
       .cutoff = 0.6,
       .frequency = 3,
       .amplitude = 0.5,
       .persistence = 0.7,
       .density = 0.95,
       .textureSide = 1024,
       .height = 1400,
       .seed = 1},
      {.octaves = 10,
       .cutoff = 0.7,
       .frequency = 6,
       .amplitude = 1,
       .persistence = 0.4,
       .density = 0.96,
       .textureSide = 1024,
       .height = 1200,
       .seed = 2},
      {.octaves = 8,
       .cutoff = 0.8,
       .frequency = 16,
       .amplitude = 0.8,
       .persistence = 0.4,
       .density = 0.96,
       .textureSide = 1024,
       .height = 900,
       .seed = 3},
  }};

  bool operator==(const CloudPlanesSettings&) const = default;
};

// Whether two layers are made of the same noise: everything else of a layer is taken over without making its
// texture again.
bool isSameNoise(const CloudPlaneSettings& a, const CloudPlaneSettings& b);

void describe(core::SettingsVisitor& visitor, CloudPlaneSettings& settings);
void describe(core::SettingsVisitor& visitor, CloudPlanesSettings& settings);

}  // namespace skydrop::clouds
