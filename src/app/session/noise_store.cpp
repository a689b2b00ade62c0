#include "app/session/noise_store.h"

#include "app/settings/xdg_folder.h"
#include "skydrop/clouds/noise_cache.h"
#include "skydrop/core/error.h"

namespace skydrop::app {

std::filesystem::path cacheFolder() { return xdgFolder("XDG_CACHE_HOME", ".cache"); }

StoredNoise NoiseStore::find(clouds::NoiseTexture texture, std::uint32_t seed) const {
  if (folder_.empty()) return {};
  clouds::CachedNoise cached = clouds::loadNoise(folder_, texture, seed);
  switch (cached.state) {
    case clouds::CacheState::good:
      return {std::move(cached.texture), true, {}};
    case clouds::CacheState::damaged:
      return {
          {}, false, clouds::noiseCacheFile(folder_, texture, seed).string() + ": damaged; it is made again"};
    case clouds::CacheState::missing:
      break;
  }
  return {};
}

std::string NoiseStore::keep(clouds::NoiseTexture texture, std::uint32_t seed,
                             const core::TextureData& made) const {
  if (folder_.empty()) return {};
  try {
    clouds::saveNoise(folder_, texture, seed, made);
    return {};
  } catch (const core::DataError& error) {
    return std::string(error.what()) + ": the noise is made again at every start";
  }
}

StoredNoise NoiseStore::get(clouds::NoiseTexture texture, std::uint32_t seed, std::stop_token stop) const {
  StoredNoise stored = find(texture, seed);
  if (stored.fromCache) return stored;
  stored.texture = clouds::makeNoise(texture, seed, stop);
  if (stored.texture.width == 0) return stored;
  if (std::string refusal = keep(texture, seed, stored.texture); !refusal.empty())
    stored.message = std::move(refusal);
  return stored;
}

}  // namespace skydrop::app
