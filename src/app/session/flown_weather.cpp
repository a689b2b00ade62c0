#include "app/session/flown_weather.h"

#include "app/session/cloud_noise.h"
#include "app/session/noise_store.h"
#include "skydrop/clouds/noise_cache.h"

namespace skydrop::app {

std::shared_ptr<const clouds::PackedCloudNoise> readFlownNoise() {
  const std::filesystem::path folder = cacheFolder();
  const NoiseStore shared(folder), ownStore(folder.empty() ? folder : folder / "simulation");
  const auto texture = [&](clouds::NoiseTexture which) {
    core::TextureData found = shared.find(which, CloudNoise::kSeed).texture;
    const std::uint64_t wanted = clouds::kMadeByProcessor[static_cast<std::size_t>(which)];
    if (found.width > 0 && clouds::noiseDigest(found) == wanted) return found;
    return (found.width > 0 ? ownStore : shared).get(which, CloudNoise::kSeed).texture;
  };
  return std::make_shared<const clouds::PackedCloudNoise>(
      clouds::packCloudNoise(texture(clouds::NoiseTexture::shape), texture(clouds::NoiseTexture::detail),
                             texture(clouds::NoiseTexture::weather)));
}

std::optional<game::WeatherSetup> flownWeather(const scene::EffectSet& effects, const Settings& settings,
                                               std::shared_ptr<const clouds::PackedCloudNoise>& noise) {
  if (!effects.contains(scene::Effect::weather)) return std::nullopt;
  if (!noise && weather::hasClouds(settings.weather)) noise = readFlownNoise();
  return game::WeatherSetup{settings.weather, settings.wind, noise};
}

}  // namespace skydrop::app
