// The weather of one moment over all places, for what looks farther than the aircraft: render, audio.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>

#include "skydrop/weather/forecast.h"
#include "skydrop/weather/handover.h"
#include "skydrop/weather/state.h"
#include "skydrop/weather/weather_settings.h"

namespace skydrop::weather {

// A value; copies share the settings, which nobody changes. Any thread.
struct Moment {
  std::shared_ptr<const WeatherSettings> settings;     // usable (requireUsable()); null: there is no weather
  std::uint64_t seed = 0;                              // of its wander
  double seconds = 0;                                  // simulated
  std::shared_ptr<const Forecast> forecast = nullptr;  // in place of the sites; null: there is none
  ForecastClock clock = {};                            // of the forecast
  std::shared_ptr<const Handover> handover = nullptr;  // of another weather to this one; null: there is none
  LayerLook lowLook = {};                              // of the low layer, everywhere

  bool operator==(const Moment&) const = default;  // of the very same settings and forecast

  explicit operator bool() const { return settings != nullptr; }
  // stateAt() there, with the look of its low layer: x east, z south, m. Only where there is weather.
  State at(const glm::dvec2& xz) const {
    State state = stateAt(*settings, forecast.get(), clock, handover.get(), seed, seconds, xz);
    lookLow(state, lowLook);
    return state;
  }
};

}  // namespace skydrop::weather
