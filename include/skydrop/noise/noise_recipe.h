// What a noise texture was made from: as a line of text, and as the note in a DDS file, so that a texture can
// be made again, or a little differently. Any thread.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "skydrop/noise/noise_settings.h"

namespace skydrop::noise {

struct NoiseRecipe {
  NoiseSettings settings;
  std::optional<PostProcess> postProcess;

  bool operator==(const NoiseRecipe&) const = default;
};

// "octaves 6, frequency 6, amplitude 0.7, persistence 0.5, seed 0, cutoff 0.5, density 0.96"
std::string recipeText(const NoiseRecipe& recipe);

// Into what core::encodeDds() made.
void putRecipe(std::span<std::byte> dds, const NoiseRecipe& recipe);
// Nothing where a file has no recipe, or one that is out of range.
std::optional<NoiseRecipe> recipeOf(std::span<const std::byte> dds);

}  // namespace skydrop::noise
