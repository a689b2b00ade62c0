// The words of `skydrop noise --generate`.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/types/command_line.h"

namespace skydrop::app {

// The words of --generate as they were given; judged together in noiseTexture().
struct NoiseWords {
  std::optional<bool> volume;  // --generate
  std::optional<int> octaves, frequency, width, height, slices;
  std::optional<double> amplitude, persistence, cutoff, density;
  std::optional<bool> alpha;
  std::optional<int> bits;
  std::vector<std::string> flags;  // that belong to --generate
};

// Settings, size and texels, with the defaults of what was not given: 512 x 512, or 128 x 128 x 128; sides
// that follow the width. Throws core::UsageError.
NoiseTextureRequest noiseTexture(const NoiseWords& words, std::uint64_t seed);

// What the export of a DDS file is called, without its ending.
std::string noiseExportName(const std::filesystem::path& file);

}  // namespace skydrop::app
