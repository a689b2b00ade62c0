// skydrop weather fetch: the newest answer of a weather service, kept in the cache folder.
#include <string>

#include "app/cli/verbs.h"
#include "app/console/standard_output.h"
#include "app/session/noise_store.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/message.h"
#include "skydrop/forecast/kept_answers.h"
#include "skydrop/forecast/read_report.h"
#include "skydrop/forecast/renewal.h"

namespace skydrop::app {
int fetchWeather(const CommandLine& line) {
  forecast::FetchRequest request = line.weather.fetch;
  if (request.provider == forecast::Provider::meteoblue)
    request.key = forecast::readKey(line.weather.keyFile);
  try {
    forecast::addressOf(request);
  } catch (const core::RangeError& error) {
    throw core::UsageError(std::string("weather fetch: ") + error.what());
  }
  std::optional<core::OutputFile> out = openOutput(line.weather.out);
  const std::filesystem::path cache = cacheFolder();
  if (cache.empty())
    throw core::DataError("the cache folder", "", "there is none: neither HOME nor XDG_CACHE_HOME is set");
  const std::filesystem::path folder = cache / "weather";
  forecast::KeptAnswer kept;
  try {
    kept = forecast::renew(folder, request, forecast::machineNow());
  } catch (const core::DataError& error) {
    const auto before = forecast::keptAnswer(folder, request);
    if (!before) throw;
    throw core::DataError(error.what(), "",
                          "the newest file is " + forecast::ageText(before->fetched, forecast::machineNow()) +
                              " old: " + before->file.string());
  }
  const std::string text = core::readTextFile(kept.file, forecast::kMostBytes);
  const forecast::Report report = forecast::readReport(text, kept.file.string(), kept.fetched);
  std::filesystem::path where = kept.file;
  if (line.weather.out) {
    where = *line.weather.out;
    out->write(text);
  }
  print("%s: %zu hours, %s to %s\n", core::printable(where.string()).c_str(), report.hours.size(),
        sky::instantText({report.hours.front().utcMs}).c_str(),
        sky::instantText({report.hours.back().utcMs}).c_str());
  return 0;
}

}  // namespace skydrop::app
