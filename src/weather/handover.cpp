#include "skydrop/weather/handover.h"

#include <algorithm>
#include <utility>

namespace skydrop::weather {
namespace {

double timeShare(const Handover& h, double seconds) {
  return std::clamp((seconds - h.beginSeconds) / h.lastsSeconds, 0.0, 1.0);
}

State plainStateAt(const WeatherSettings& settings, const Forecast* forecast, const ForecastClock& clock,
                   std::uint64_t seed, double seconds, const glm::dvec2& xz) {
  return forecast ? stateAt(settings, *forecast, clock, seed, seconds, xz)
                  : stateAt(settings, seed, seconds, xz);
}

}  // namespace

double newShare(const Handover& handover, double seconds) {
  const double x = timeShare(handover, seconds);
  return x * x * (3 - 2 * x);
}

Handover turnedBack(const Handover& handover, std::shared_ptr<const Forecast> arriving,
                    const ForecastClock& clock, double seconds) {
  const double left = 1 - timeShare(handover, seconds);
  return {std::move(arriving), clock, seconds - left * handover.lastsSeconds, handover.lastsSeconds};
}

Forecast continuing(Forecast next, const Forecast& before) {
  next.originMs = originMs(before);
  next.strandWind = strandWind(before);
  return next;
}

State stateAt(const WeatherSettings& settings, const Forecast* forecast, const ForecastClock& clock,
              const Handover* handover, std::uint64_t seed, double seconds, const glm::dvec2& xz) {
  const double share = handover ? newShare(*handover, seconds) : 1;
  if (share >= 1) return plainStateAt(settings, forecast, clock, seed, seconds, xz);
  const State before = plainStateAt(settings, handover->from.get(), handover->clock, seed, seconds, xz);
  if (share <= 0) return before;
  return mixed(before, plainStateAt(settings, forecast, clock, seed, seconds, xz), share);
}

void describe(core::SettingsVisitor& v, LiveSettings& s) {
  v.flag("follow", s.follow,
         {.help = "The weather follows the forecast of a file or service; off: it is made by hand.",
          .aliases = "forecast, live, play, real weather"});
  v.number("blendSeconds", s.blendSeconds,
           {.unit = "s",
            .min = 0,
            .max = 3600,
            .help = "How long a newer forecast takes to replace the weather before it.",
            .slider = core::Range{0, 300},
            .aliases = "forecast, live, renewal"});
  v.number("renewMinutes", s.renewMinutes,
           {.unit = "min",
            .min = 1,
            .max = 1440,
            .help = "How often a weather service is asked for a newer forecast (--live); 1440 is daily.",
            .slider = core::Range{5, 1440},
            .aliases = "forecast, live, renewal, period"});
}

}  // namespace skydrop::weather
