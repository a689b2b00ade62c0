// The settings of a noise texture: what noise it holds, and how it is cut to clouds.
// Source: Tarantilis, "Simulating Clouds with Procedural Texturing Techniques Using the GPU", 2004, chapter
// III.
#pragma once

#include <cstdint>

#include "skydrop/core/settings.h"

namespace skydrop::noise {

// A sum of octaves of gradient noise, each of twice the frequency of the one before and `persistence` times
// its weight, as a value in [0, 1] around 0.5.
struct NoiseSettings {
  std::int64_t octaves = 6;    // 1 .. 16
  std::int64_t frequency = 6;  // lattice cells to a period in the first octave, 1 .. 512
  double amplitude = 0.7;      // weight of the first octave, 0 .. 4
  double persistence = 0.5;    // 0 .. 1
  std::int64_t seed = 0;       // 0 .. 2^32 - 1

  bool operator==(const NoiseSettings&) const = default;
};

// Noise cut to clouds: a value up to the cutoff becomes 0, one above it 1 - density^(255 (value - cutoff)).
struct PostProcess {
  double cutoff = 0.5;    // 0 .. 1; more leaves fewer clouds
  double density = 0.96;  // 0 .. 1; less gives harder edges, 0 a step, 1 nothing at all

  bool operator==(const PostProcess&) const = default;
};

void describe(core::SettingsVisitor& visitor, NoiseSettings& settings);
void describe(core::SettingsVisitor& visitor, PostProcess& postProcess);

}  // namespace skydrop::noise
