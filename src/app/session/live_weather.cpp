#include "app/session/live_weather.h"

#include <optional>

#include "app/session/noise_store.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/forecast/forecast_of.h"
#include "skydrop/forecast/read_report.h"

namespace skydrop::app {

LiveWeather liveWeather(const LiveRequest& live, bool needsAnswer) {
  LiveWeather out;
  forecast::FetchRequest& request = out.setup.request = live.fetch;
  if (request.provider == forecast::Provider::meteoblue) request.key = forecast::readKey(live.keyFile);
  try {
    forecast::addressOf(request);
  } catch (const core::RangeError& error) {
    throw core::UsageError(std::string("--live: ") + error.what());
  }
  const std::filesystem::path cache = cacheFolder();
  if (cache.empty())
    throw core::DataError("the cache folder", "", "there is none: neither HOME nor XDG_CACHE_HOME is set");
  out.setup.folder = cache / "weather";
  std::optional<forecast::KeptAnswer> kept = forecast::keptAnswer(out.setup.folder, request);
  if (!kept && needsAnswer) {
    // Somebody waits for the window.
    const forecast::FetchLimits limits{.connectS = 5, .stallS = 5, .totalS = 12, .attempts = 1};
    kept = forecast::renew(out.setup.folder, request, forecast::machineNow(), limits);
  }
  if (!kept || !needsAnswer) return out;
  out.file = kept->file;
  out.setup.fetched = kept->fetched;
  out.setup.digest = forecast::contentDigest(core::readTextFile(kept->file, forecast::kMostBytes));
  out.notes.push_back(kept->file.string() + ": fetched " +
                      forecast::ageText(kept->fetched, forecast::machineNow()) + " ago");
  return out;
}

}  // namespace skydrop::app
