#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/cli/verbs.h"
#include "app/cli/weather_json.h"
#include "app/console/message.h"
#include "app/console/standard_output.h"
#include "app/session/flown_weather.h"
#include "app/session/ground.h"
#include "app/session/run_config.h"
#include "skydrop/game/contact.h"
#include "skydrop/game/flown_clouds.h"
#include "skydrop/game/ice_layers.h"
#include "skydrop/sky/instant.h"
#include "skydrop/weather/draughts.h"
#include "skydrop/weather/dryden.h"
#include "skydrop/weather/lightning.h"
#include "skydrop/weather/standard_atmosphere.h"
#include "skydrop/weather/wind_profile.h"

namespace skydrop::app {
namespace {

using Json = nlohmann::ordered_json;

double siteShareOf(const game::WeatherSetup& setup, double seconds, const glm::dvec2& xz) {
  return setup.forecast ? weather::siteShare(setup.settings, *setup.forecast, seconds, xz)
                        : weather::siteShare(setup.settings, seconds, xz);
}

// Null without weather files.
Json forecastJson(const game::WeatherSetup& setup, double seconds) {
  if (!setup.forecast) return nullptr;
  const weather::Forecast& forecast = *setup.forecast;
  const double ms = weather::utcMsAt(forecast, setup.clock, seconds);
  const auto held = [&](const weather::Timeline& site) {
    return weather::kHeldNames[static_cast<std::size_t>(weather::heldAt(site, ms))];
  };
  return {{"utc", sky::instantText({std::llround(ms)})},
          {"near", held(forecast.near)},
          {"far", held(forecast.far)},
          {"farFromNearM",
           forecast.farFromNear ? Json({forecast.farFromNear->x, forecast.farFromNear->y}) : Json(nullptr)}};
}

// The flashes of the next minute within sight.
Json flashesJson(const RunConfig& run, double seconds, const glm::dvec3& at) {
  const weather::Moment moment{std::make_shared<const weather::WeatherSettings>(run.settings.weather),
                               run.setup.seed,
                               seconds,
                               nullptr,
                               {},
                               nullptr,
                               game::lookOf(run.settings.clouds.layers[0])};
  Json flashes = Json::array();
  for (const weather::Flash& flash :
       weather::flashesBetween(moment, run.settings.lightning, seconds, seconds + 60, {at.x, at.z}))
    flashes.push_back({{"seconds", flash.seconds},
                       {"toGround", flash.toGround},
                       {"fromM", {flash.from.x, flash.from.y, flash.from.z}},
                       {"toM", {flash.to.x, flash.to.y, flash.to.z}},
                       {"strokes", flash.strokeCount}});
  return flashes;
}

}  // namespace

int weather(const CommandLine& line) {
  if (line.weather.verb == WeatherVerb::check) return checkWeather(line);
  if (line.weather.verb == WeatherVerb::fetch) return fetchWeather(line);
  const std::unique_ptr<RunConfig> run = prepareRun(line);
  const Settings& settings = run->settings;
  const scene::EffectSet effects = effectsOf(*run);
  const auto ground = makeGround(effects, settings, run->setup);
  const glm::dvec3& at = line.weatherAt;
  for (const std::string& note : run->notes) warn(note);
  std::shared_ptr<const clouds::PackedCloudNoise> noise;
  scene::EffectSet flownEffects = effects;
  flownEffects.insert(scene::Effect::weather);  // what a scene would have, with the effect or without
  Settings flown = settings;
  const auto forecast = settings.live.follow ? run->setup.forecast : nullptr;
  if (forecast) flown.weatherFile = forecastClock(settings, *forecast);
  const game::WeatherSetup setup = *flownWeather(flownEffects, flown, noise, forecast);
  const weather::State state = setup.at(run->setup.seed, line.timeS, {at.x, at.z});
  const double surface = game::surfaceAt(*ground, {at.x, at.z}).height;
  const double above = std::max(at.y - surface, 0.0);
  const weather::WindProfile profile(state.wind);
  const glm::dvec3 wind = profile.at(at.y, above);
  const weather::Air air = settings.weather.standardAtmosphere
                               ? weather::airAt(at.y, state.temperatureC, state.pressurePa)
                               : weather::Air{};
  const game::FlownClouds clouds(setup.noise, setup.drift,
                                 game::iceWindOf(settings.weather, setup.forecast.get()));
  const double density = clouds.density(state, at, line.timeS);
  double rising = 0, cloudSigma2 = 0;
  for (const weather::Layer& layer : state.layers) {
    rising += weather::cloudDraught(layer, clouds.column(layer, at, line.timeS), at.y, surface,
                                    state.precipitation.rain);
    const double rough = weather::airOf(layer.genus).turbulenceMps * std::min(layer.density, 2.0) *
                         clouds.density(layer, at, line.timeS);
    cloudSigma2 += rough * rough;
  }
  const weather::DrydenScales scales =
      weather::drydenScales(above, profile.w20Mps(), state.turbulenceSeverity);
  const auto sigma = [&](double clear) {
    return settings.weather.turbulence * std::sqrt(clear * clear + cloudSigma2);
  };
  const glm::dvec3& clear = scales.intensityMps;
  const Json report = {{"scene", run->setup.scene.name},
                       {"seed", run->setup.seed},
                       {"seconds", line.timeS},
                       {"isFlown", effects.contains(scene::Effect::weather)},
                       {"siteShare", siteShareOf(setup, line.timeS, {at.x, at.z})},
                       {"forecast", forecastJson(setup, line.timeS)},
                       {"state", stateJson(state)},
                       {"at",
                        {{"positionM", {at.x, at.y, at.z}},
                         {"surfaceM", surface},
                         {"windMps", {wind.x, wind.y, wind.z}},
                         {"risingMps", rising * settings.weather.draughts},
                         {"cloudDensity", density},
                         {"turbulence",
                          {{"w20Mps", profile.w20Mps()},
                           {"intensityMps", {sigma(clear.x), sigma(clear.y), sigma(clear.z)}},
                           {"lengthM", {scales.lengthM.x, scales.lengthM.y, scales.lengthM.z}}}},
                         {"air",
                          {{"temperatureC", air.temperatureK - 273.15},
                           {"pressurePa", air.pressurePa},
                           {"densityKgM3", air.densityKgM3},
                           {"soundMps", air.soundMps}}}}},
                       {"flashes", flashesJson(*run, line.timeS, at)}};
  print("%s\n", report.dump(2).c_str());
  return 0;
}

}  // namespace skydrop::app
