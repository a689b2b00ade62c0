// Noise textures kept between runs: the normal way to have them. Any thread; several programs may share a
// folder.
#pragma once

#include <cstdint>
#include <filesystem>

#include "skydrop/clouds/noise_textures.h"

namespace skydrop::clouds {

// Raised when the definition of the noise changes; a test holds it to a digest of the textures.
inline constexpr std::uint64_t kNoiseDefinition = 1;

std::uint64_t noiseDigest(const core::TextureData& texture);

// Of what clouds::makeNoise() makes with seed 0, by NoiseTexture: a shader's division and root differ by a
// step in one texel of 100 000, which a picture does not show and a simulation must not meet.
inline constexpr std::uint64_t kMadeByProcessor[] = {15652582648506124404u, 15171973740172691631u,
                                                     12613845850247122945u};

enum class CacheState { missing, damaged, good };

struct CachedNoise {
  CacheState state = CacheState::missing;
  core::TextureData texture;  // of the right size when good, else empty
};

// One file a texture; the name carries the definition and the seed.
std::filesystem::path noiseCacheFile(const std::filesystem::path& folder, NoiseTexture texture,
                                     std::uint32_t seed);

// Damaged is whatever is there and is not, to the last bit, what was written: the file is remade by whoever
// asks.
CachedNoise loadNoise(const std::filesystem::path& folder, NoiseTexture texture, std::uint32_t seed);

// Makes the folder. Throws core::DataError where it cannot be written.
void saveNoise(const std::filesystem::path& folder, NoiseTexture texture, std::uint32_t seed,
               const core::TextureData& made);

}  // namespace skydrop::clouds
