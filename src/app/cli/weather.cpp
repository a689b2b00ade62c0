#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/cli/verbs.h"
#include "app/console/standard_output.h"
#include "app/session/flown_weather.h"
#include "app/session/run_config.h"
#include "skydrop/game/contact.h"
#include "skydrop/game/flown_clouds.h"
#include "skydrop/terrain/analytic_height_sources.h"
#include "skydrop/terrain/noise_height_source.h"
#include "skydrop/weather/draughts.h"
#include "skydrop/weather/dryden.h"
#include "skydrop/weather/standard_atmosphere.h"
#include "skydrop/weather/wind_profile.h"

namespace skydrop::app {
namespace {

using Json = nlohmann::ordered_json;

Json windJson(const weather::Wind& wind) {
  Json levels = Json::array();
  for (const weather::WindLevel& level : wind.levels)
    levels.push_back(
        {{"heightM", level.heightM}, {"speedMps", level.speedMps}, {"directionDeg", level.directionDeg}});
  return {
      {"speedMps", wind.speedMps},     {"directionDeg", wind.directionDeg},       {"gustMps", wind.gustMps},
      {"roughnessM", wind.roughnessM}, {"gradientHeightM", wind.gradientHeightM}, {"levels", levels}};
}

Json stateJson(const weather::State& s) {
  Json layers = Json::array();
  for (const weather::Layer& layer : s.layers) {
    if (!(layer.cover > 0)) continue;
    layers.push_back({{"genus", weather::kGenusNames[static_cast<std::size_t>(layer.genus)]},
                      {"baseM", layer.baseM},
                      {"topM", layer.topM},
                      {"cover", layer.cover},
                      {"density", layer.density}});
  }
  return {{"wind", windJson(s.wind)},
          {"layers", layers},
          {"fog", {{"extinctionPerM", s.fog.extinction}, {"topM", s.fog.topM}}},
          {"precipitationMmPerH",
           {{"rain", s.precipitation.rain},
            {"snow", s.precipitation.snow},
            {"sleet", s.precipitation.sleet},
            {"hail", s.precipitation.hail}}},
          {"visibilityM", s.visibilityM},
          {"temperatureC", s.temperatureC},
          {"pressurePa", s.pressurePa},
          {"lightningPerMinute", s.lightningPerMinute},
          {"turbulenceSeverity", s.turbulenceSeverity}};
}

}  // namespace

int weather(const CommandLine& line) {
  const std::unique_ptr<RunConfig> run = prepareRun(line);
  const Settings& settings = run->settings;
  const scene::EffectSet effects = effectsOf(*run);
  const bool hasLand = effects.contains(scene::Effect::terrain);
  const auto ground = hasLand ? terrain::makeNoiseHeightSource(settings.terrain, run->setup.seed)
                              : terrain::makeFlatSource(0);
  const glm::dvec3& at = line.weatherAt;
  const weather::State state = weather::stateAt(settings.weather, run->setup.seed, line.timeS, {at.x, at.z});
  const double surface = game::surfaceAt(*ground, {at.x, at.z}).height;
  const double above = std::max(at.y - surface, 0.0);
  const weather::WindProfile profile(state.wind);
  const glm::dvec3 wind = profile.at(at.y, above);
  const weather::Air air = settings.weather.standardAtmosphere
                               ? weather::airAt(at.y, state.temperatureC, state.pressurePa)
                               : weather::Air{};
  const game::FlownClouds clouds(weather::hasClouds(settings.weather) ? readFlownNoise() : nullptr,
                                 settings.wind);
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
                       {"siteShare", weather::siteShare(settings.weather, line.timeS, {at.x, at.z})},
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
                           {"soundMps", air.soundMps}}}}}};
  print("%s\n", report.dump(2).c_str());
  return 0;
}

}  // namespace skydrop::app
