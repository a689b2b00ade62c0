#include "app/noise_store.h"

#include "app/xdg_folder.h"
#include "skydrop/clouds/noise_cache.h"
#include "skydrop/core/error.h"

namespace skydrop::app {

std::filesystem::path cacheFolder() { return xdgFolder("XDG_CACHE_HOME", ".cache"); }

StoredNoise NoiseStore::get(clouds::NoiseTexture texture, std::uint32_t seed, std::stop_token stop) const {
  StoredNoise stored;
  if (!folder_.empty()) {
    clouds::CachedNoise cached = clouds::loadNoise(folder_, texture, seed);
    if (cached.state == clouds::CacheState::good) return {std::move(cached.texture), true, {}};
    if (cached.state == clouds::CacheState::damaged) {
      stored.message =
          clouds::noiseCacheFile(folder_, texture, seed).string() + ": damaged; it is made again";
    }
  }
  stored.texture = clouds::makeNoise(texture, seed, stop);
  if (folder_.empty() || stored.texture.width == 0) return stored;
  try {
    clouds::saveNoise(folder_, texture, seed, stored.texture);
  } catch (const core::DataError& error) {
    stored.message = std::string(error.what()) + ": the noise is made anew at every start";
  }
  return stored;
}

}  // namespace skydrop::app
