#include "skydrop/weather/forecast.h"

#include <algorithm>
#include <string>
#include <utility>

#include "skydrop/core/error.h"
#include "weather/site_weather.h"

namespace skydrop::weather {
namespace {

constexpr double kMsPerHour = 3.6e6;

glm::dvec2 placeOf(const SiteSettings& site) { return {site.eastM, -site.northM}; }

}  // namespace

Timeline::Timeline(std::vector<TimedState> states) : states_(std::move(states)) {
  if (states_.empty()) throw core::RangeError("there is no hour");
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const std::string place = "hour " + std::to_string(i) + ": ";
    if (i > 0 && states_[i].utcMs <= states_[i - 1].utcMs)
      throw core::RangeError(place + "its time is not after that of the hour before");
    try {
      requireUsable(states_[i].state);
    } catch (const core::RangeError& error) {
      throw core::RangeError(place + error.what());
    }
  }
}

State Timeline::at(double utcMs) const {
  if (!(utcMs > static_cast<double>(firstMs()))) return states_.front().state;
  if (utcMs >= static_cast<double>(lastMs())) return states_.back().state;
  const auto after = std::ranges::upper_bound(
      states_, utcMs, {}, [](const TimedState& timed) { return static_cast<double>(timed.utcMs); });
  const TimedState &from = *std::prev(after), &to = *after;
  return mixed(from.state, to.state,
               (utcMs - static_cast<double>(from.utcMs)) / static_cast<double>(to.utcMs - from.utcMs));
}

void describe(core::SettingsVisitor& v, ForecastClock& s) {
  v.flag("followsSky", s.followsSky,
         {.help = "Where the clock moves the sun (sky.sun) its time is that of the weather file too.",
          .aliases = "forecast, time, clock"});
  v.number("hour", s.hour,
           {.unit = "h",
            .min = -1e6,
            .max = 1e6,
            .help = "Hour of the weather file at the start of the flight, from its first on.",
            .slider = core::Range{0, 168},
            .aliases = "forecast, time, clock"});
  v.number("pace", s.pace,
           {.unit = "1",
            .min = 0,
            .max = 3600,
            .help = "How fast time runs through the weather file.",
            .slider = core::Range{0, 600},
            .aliases = "forecast, time lapse, speed"});
}

std::int64_t originMs(const Forecast& forecast) {
  return forecast.originMs ? *forecast.originMs : forecast.near.firstMs();
}

const Wind& strandWind(const Forecast& forecast) {
  return forecast.strandWind ? *forecast.strandWind : forecast.near.states().front().state.wind;
}

double utcMsAt(const Forecast& forecast, const ForecastClock& clock, double seconds) {
  return static_cast<double>(originMs(forecast)) + clock.hour * kMsPerHour + seconds * clock.pace * 1000;
}

Held heldAt(const Timeline& timeline, double utcMs) {
  if (utcMs < static_cast<double>(timeline.firstMs())) return Held::before;
  return utcMs > static_cast<double>(timeline.lastMs()) ? Held::after : Held::within;
}

double siteShare(const WeatherSettings& s, const Forecast& forecast, double seconds, const glm::dvec2& xz) {
  const glm::dvec2 near = placeOf(s.sites[0]);
  const glm::dvec2 far = forecast.farFromNear
                             ? near + glm::dvec2(forecast.farFromNear->x, -forecast.farFromNear->y)
                             : placeOf(s.sites[1]);
  return shareAlong(near, far, s.approachSeconds, seconds, xz);
}

State stateAt(const WeatherSettings& s, const Forecast& forecast, const ForecastClock& clock,
              std::uint64_t seed, double seconds, const glm::dvec2& xz) {
  const double share = siteShare(s, forecast, seconds, xz);
  const double utcMs = utcMsAt(forecast, clock, seconds);
  State out = share <= 0   ? forecast.near.at(utcMs)
              : share >= 1 ? forecast.far.at(utcMs)
                           : mixed(forecast.near.at(utcMs), forecast.far.at(utcMs), share);
  letWander(out, s, seed, seconds);
  return out;
}

bool hasClouds(const Forecast& forecast) {
  const auto clouded = [](const TimedState& timed) {
    return std::ranges::any_of(timed.state.layers, [](const Layer& layer) { return layer.cover > 0; });
  };
  return std::ranges::any_of(forecast.near.states(), clouded) ||
         std::ranges::any_of(forecast.far.states(), clouded);
}

}  // namespace skydrop::weather
