// Weather over time, as files gave it: states of a near and a far site at instants, and the state between
// them. It takes the place of the sites made by hand (weather_settings.h); module `forecast` makes it.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "skydrop/core/settings.h"
#include "skydrop/weather/state.h"
#include "skydrop/weather/weather_settings.h"

namespace skydrop::weather {

struct TimedState {
  std::int64_t utcMs = 0;  // since 1970-01-01T00:00:00Z
  State state;
};

// The states of one site in the order of time. Immutable; any thread.
class Timeline {
 public:
  // Throws core::RangeError ("hour 3: layers.1: ...") unless there is a state, times ascend strictly and
  // every state is usable.
  explicit Timeline(std::vector<TimedState> states);

  std::int64_t firstMs() const { return states_.front().utcMs; }
  std::int64_t lastMs() const { return states_.back().utcMs; }
  const std::vector<TimedState>& states() const { return states_; }

  // mixed() between the two states around an instant; before the first the first and after the last the last,
  // and for an instant that is not a number the first.
  State at(double utcMs) const;

 private:
  std::vector<TimedState> states_;
};

// Whether an instant lies within a timeline, or a state is held.
enum class Held { within, before, after };
inline constexpr std::array<std::string_view, 3> kHeldNames = {"within", "before", "after"};

struct Forecast {
  Timeline near, far;                     // far: the second site
  std::optional<glm::dvec2> farFromNear;  // m, east and north; without: as the sites of the settings lie
  std::uint64_t digest = 0;               // of the content of the files
  // Of a forecast that took over while flying, those of the one before (handover.h); without, its own.
  std::optional<std::int64_t> originMs = std::nullopt;  // from which ForecastClock counts
  std::optional<Wind> strandWind = std::nullopt;        // that forms the strands of ice clouds
};

// The instant from which ForecastClock counts hours: that of the first state of the first forecast.
std::int64_t originMs(const Forecast& forecast);
// The wind whose shear forms the strands of ice clouds: the near site's in the first hour of the first
// forecast.
const Wind& strandWind(const Forecast& forecast);

// How simulated time runs through a forecast.
struct ForecastClock {
  bool followsSky = true;  // hour and pace are set by the clock of the sky where that moves the sun
  double hour = 0;         // h, -1e6 .. 1e6, of the start of the flight after originMs()
  double pace = 1;         // 0 .. 3600: seconds of the forecast's time that pass in a simulated one

  bool operator==(const ForecastClock&) const = default;
};

void describe(core::SettingsVisitor& visitor, ForecastClock& clock);

// The instant of the forecast at a simulated time, ms since 1970.
double utcMsAt(const Forecast& forecast, const ForecastClock& clock, double seconds);
Held heldAt(const Timeline& timeline, double utcMs);

// siteShare() and stateAt() of weather_settings.h under a forecast: its two sites in place of those of the
// settings, whose positions count where the forecast has none. Pure; usable.
double siteShare(const WeatherSettings& settings, const Forecast& forecast, double seconds,
                 const glm::dvec2& xz);
State stateAt(const WeatherSettings& settings, const Forecast& forecast, const ForecastClock& clock,
              std::uint64_t seed, double seconds, const glm::dvec2& xz);

bool hasClouds(const Forecast& forecast);

}  // namespace skydrop::weather
