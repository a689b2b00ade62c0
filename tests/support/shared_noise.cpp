#include "support/shared_noise.h"

#include <array>
#include <cstdlib>
#include <utility>

#include "skydrop/clouds/noise_cache.h"
#include "support/paths.h"

namespace skydrop::test {
namespace {

constexpr std::uint32_t kSeed = 0;

std::filesystem::path folder() { return sharedCacheHome() / "skydrop"; }

}  // namespace

core::TextureData sharedTexture(clouds::NoiseTexture texture) {
  clouds::CachedNoise cached = clouds::loadNoise(folder(), texture, kSeed);
  if (cached.state == clouds::CacheState::good) return std::move(cached.texture);
  core::TextureData made = clouds::makeNoise(texture, kSeed);
  clouds::saveNoise(folder(), texture, kSeed, made);
  return made;
}

std::filesystem::path sharedCacheHome() {
  const char* given = std::getenv("SKYDROP_TEST_CACHE");
  if (given != nullptr && *given != '\0') return given;
  return std::filesystem::path(test::binaryDir()) / "tests" / "cache";
}

std::shared_ptr<const clouds::PackedCloudNoise> sharedNoise() {
  using enum clouds::NoiseTexture;
  static const auto noise = std::make_shared<const clouds::PackedCloudNoise>(
      clouds::packCloudNoise(sharedTexture(shape), sharedTexture(detail), sharedTexture(weather)));
  return noise;
}

void copySharedNoise(const std::filesystem::path& cacheFolder) {
  static_cast<void>(sharedNoise());
  std::filesystem::create_directories(cacheFolder);
  for (const clouds::NoiseTexture texture : clouds::kNoiseTextures) {
    std::filesystem::copy_file(clouds::noiseCacheFile(folder(), texture, kSeed),
                               clouds::noiseCacheFile(cacheFolder, texture, kSeed),
                               std::filesystem::copy_options::overwrite_existing);
  }
}

}  // namespace skydrop::test
