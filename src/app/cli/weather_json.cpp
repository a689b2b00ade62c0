#include "app/cli/weather_json.h"

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

}  // namespace

nlohmann::ordered_json stateJson(const weather::State& s) {
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

}  // namespace skydrop::app
