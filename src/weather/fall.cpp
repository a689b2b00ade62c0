#include "skydrop/weather/fall.h"

#include <algorithm>
#include <array>

namespace skydrop::weather {
namespace {

constexpr std::array kFeeding = {Genus::cumulonimbus, Genus::nimbostratus,  Genus::altostratus,
                                 Genus::cumulus,      Genus::stratocumulus, Genus::stratus,
                                 Genus::altocumulus};
constexpr double kLapsePerM = 0.0065;           // of the standard atmosphere
constexpr double kBasePerDegreeM = 125;         // of the spread between temperature and dew point
constexpr double kEvaporationPerDegree = 1e-4;  // mm/h a metre, at 15 degrees
constexpr double kUsualTemperatureC = 15;

}  // namespace

const Layer* feedingLayer(const State& state) {
  for (const Genus genus : kFeeding) {
    for (const Layer& layer : state.layers) {
      if (layer.genus == genus && layer.cover > 0) return &layer;
    }
  }
  return nullptr;
}

bool fallsEverywhere(const Layer& layer) {
  const bool isCumuliform = layer.genus == Genus::cumulonimbus || layer.genus == Genus::cumulus ||
                            layer.genus == Genus::stratocumulus || layer.genus == Genus::altocumulus;
  return !isCumuliform || layer.cover >= 0.9;
}

double rateOf(const Precipitation& fall) { return fall.rain + fall.snow + fall.sleet + fall.hail; }

std::optional<FallField> fallField(const State& state) {
  const double rate = rateOf(state.precipitation);
  const Layer* layer = feedingLayer(state);
  if (!(rate > 0) || !layer) return std::nullopt;
  const double warm = std::clamp(state.temperatureC / kUsualTemperatureC, 0.1, 2.0);
  FallField field{};
  field.baseM = layer->baseM;
  field.topM = layer->topM;
  field.groundRate = rate;
  field.evaporation = kEvaporationPerDegree * layer->baseM / kBasePerDegreeM * warm;
  field.freezingM = state.temperatureC / kLapsePerM;
  field.snowShare = state.precipitation.snow / rate;
  return field;
}

Precipitation fallAt(const State& state, double heightM, double share) {
  const std::optional<FallField> field = fallField(state);
  if (!field) return {};
  namespace shared = core::shared::f64;
  const double all = shared::fallRate(*field, heightM, share) / field->groundRate;
  // snowAt() is of rain and snow together: what it gives beyond the state's own snow is frozen rain.
  FallField ofRain = *field;
  ofRain.snowShare = 0;
  const double frozen = shared::snowAt(ofRain, heightM);
  const Precipitation& ground = state.precipitation;
  return {.rain = all * ground.rain * (1 - frozen),
          .snow = all * (ground.snow + ground.rain * frozen),
          .sleet = all * ground.sleet,
          .hail = all * ground.hail};
}

}  // namespace skydrop::weather
