// One weather that takes over from another while flying, without a jump: a newer forecast from an older one,
// a forecast from the sites made by hand, or the other way round.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>

#include "skydrop/weather/forecast.h"
#include "skydrop/weather/state.h"
#include "skydrop/weather/weather_settings.h"

namespace skydrop::weather {

// The weather before, and when it goes. A value; any thread.
struct Handover {
  std::shared_ptr<const Forecast> from;  // null: the sites of the settings
  ForecastClock clock = {};              // of `from`
  double beginSeconds = 0;               // simulated
  double lastsSeconds = 1;               // simulated, > 0

  bool operator==(const Handover&) const = default;
};

// The share of the new weather, [0, 1]: 3 x^2 - 2 x^3 of the share x of the time, so that it begins and ends
// level.
double newShare(const Handover& handover, double seconds);

// The same way back: from the weather that was about to come to the one that was about to go, which have
// equal shares at `seconds`. `arriving`, `clock`: of the weather that was about to come.
Handover turnedBack(const Handover& handover, std::shared_ptr<const Forecast> arriving,
                    const ForecastClock& clock, double seconds);

// The forecast as it goes on where another was: its clock counts from the same instant, and the strands of
// the ice clouds keep their wind.
Forecast continuing(Forecast next, const Forecast& before);

// stateAt() of the forecast, or of the sites where it is null, while it takes over from what the handover
// names; null: nothing is handed over. Pure; usable, and continuous in time where both weathers are.
State stateAt(const WeatherSettings& settings, const Forecast* forecast, const ForecastClock& clock,
              const Handover* handover, std::uint64_t seed, double seconds, const glm::dvec2& xz);

// What decides whether the weather follows a forecast, and how a newer one comes.
struct LiveSettings {
  bool follow = true;        // off: the sites made by hand count, whatever files there are
  double blendSeconds = 60;  // s, 0 .. 3600, simulated: a weather takes over from another
  double renewMinutes = 60;  // min, 1 .. 1440: a service is asked again (--live)
};

void describe(core::SettingsVisitor& visitor, LiveSettings& settings);

}  // namespace skydrop::weather
