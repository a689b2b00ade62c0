#include "app/session/flown_weather.h"

#include <algorithm>

#include "app/session/cloud_noise.h"
#include "app/session/noise_store.h"
#include "skydrop/clouds/noise_cache.h"
#include "skydrop/game/flown_clouds.h"

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
                                               std::shared_ptr<const clouds::PackedCloudNoise>& noise,
                                               const std::shared_ptr<const weather::Forecast>& forecast) {
  if (!effects.contains(scene::Effect::weather)) return std::nullopt;
  const bool clouded = forecast ? weather::hasClouds(*forecast) : weather::hasClouds(settings.weather);
  if (!noise && clouded) noise = readFlownNoise();
  game::WeatherSetup setup{settings.weather, settings.wind, noise, forecast, settings.weatherFile};
  setup.lowLook = game::lookOf(settings.clouds.layers[0]);
  return setup;
}

weather::ForecastClock forecastClock(const Settings& settings, const weather::Forecast& forecast) {
  weather::ForecastClock clock = settings.weatherFile;
  const render::SunSettings& sun = settings.render.sun;
  if (!clock.followsSky || sun.source != render::SunSource::clock) return clock;
  const double ms = static_cast<double>(sun.utcMs - weather::originMs(forecast));
  clock.hour =
      std::clamp(ms / 3.6e6 + sun.shiftDays * 24 + sun.shiftHours + sun.offsetSeconds / 3600, -1e6, 1e6);
  clock.pace = sun.timeScale;
  return clock;
}

}  // namespace skydrop::app
