// The three noise textures that clouds are made of, made on the processor. The definition is
// shaders/shared/cloud_noise.glsl; render::NoiseMaker runs the same on the GPU and noise_scripts/ in Python.
// Any thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stop_token>
#include <string_view>

#include "skydrop/core/dds.h"

namespace skydrop::clouds {

// shape: 128^3, Perlin-Worley and three Worley fBm. detail: 32^3, three Worley fBm. weather: 512^2, coverage,
// precipitation and type. All rgba8, all periodic.
enum class NoiseTexture { shape, detail, weather };

inline constexpr std::array kNoiseTextures = {NoiseTexture::shape, NoiseTexture::detail,
                                              NoiseTexture::weather};

struct NoiseLayout {
  std::string_view name;
  int side;       // texels
  bool isVolume;  // else a map

  // What is made at a time: a layer of a volume, a row of a map.
  int slices() const { return side; }
  std::size_t sliceBytes() const;
};

const NoiseLayout& noiseLayout(NoiseTexture texture);
core::TextureData emptyNoise(NoiseTexture texture);  // of the right size, all zero

// Slices `first` to `first + texels.size() / sliceBytes() - 1`. About 0.5 ms to 5 ms a slice.
void fillNoise(NoiseTexture texture, std::uint32_t seed, int first, std::span<std::byte> texels);

// The whole texture, or empty (width 0) when it was stopped before.
core::TextureData makeNoise(NoiseTexture texture, std::uint32_t seed, std::stop_token stop = {});

// Largest and mean difference of two textures of one size, in 8-bit steps.
struct NoiseDifference {
  int largest = 0;
  double mean = 0;
};
NoiseDifference noiseDifference(const core::TextureData& a, const core::TextureData& b);

// How much rougher a texture is across its borders than inside: the mean step between neighbouring texels
// over each pair of opposite faces, divided by the mean step inside along the same axis; the largest of the
// axes. About 1 for what tiles. Channels that are constant count as smooth, and so does an axis of one texel;
// never NaN, whatever a float texture holds.
double seamRoughness(const core::TextureData& texture);

}  // namespace skydrop::clouds
