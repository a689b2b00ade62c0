// The noise textures as the program gets them: from the player's cache folder, or made and put there.
#pragma once

#include <filesystem>
#include <string>

#include "skydrop/clouds/noise_textures.h"

namespace skydrop::app {

// $XDG_CACHE_HOME/skydrop, or ~/.cache/skydrop; empty where neither variable is set.
std::filesystem::path cacheFolder();

struct StoredNoise {
  core::TextureData texture;
  bool fromCache = false;
  std::string message;  // one line when the cache was damaged or cannot be written; else empty
};

// Any thread. Without a folder nothing is kept.
class NoiseStore {
 public:
  explicit NoiseStore(std::filesystem::path folder) : folder_(std::move(folder)) {}

  // From the cache; an empty texture where it is not there or damaged.
  StoredNoise find(clouds::NoiseTexture texture, std::uint32_t seed) const;
  // Puts it there; the line to warn with where that fails, else empty.
  std::string keep(clouds::NoiseTexture texture, std::uint32_t seed, const core::TextureData& made) const;

  // From the cache, or made on this thread (1.4 s for the shape) and kept. A damaged file is remade. An empty
  // texture when it was stopped before it was made.
  StoredNoise get(clouds::NoiseTexture texture, std::uint32_t seed, std::stop_token stop = {}) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace skydrop::app
