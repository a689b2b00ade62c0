#include "app/cli/weather_flags.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <functional>
#include <optional>

#include "app/cli/flag_options.h"
#include "app/cli/flag_values.h"
#include "skydrop/core/error.h"

namespace skydrop::app {

using core::UsageError;

void WeatherFlags::add(CLI::App& verb, CommandLine& line) {
  WeatherRequest& request = line.weather;
  verb.add_option_function<std::string>(
          "WHAT",
          [&request](const std::string& t) {
            const auto what = std::ranges::find(kWeatherVerbs, t);
            if (what == kWeatherVerbs.end())
              throw UsageError("weather: '" + t + "' is not one of state check fetch");
            request.verb = static_cast<WeatherVerb>(what - kWeatherVerbs.begin());
          },
          "state: the whole state, with wind, turbulence and cloud at the point; check: what weather files "
          "say, hour by hour, and what they lack; fetch: ask a service, and keep its answer in the cache "
          "folder")
      ->required();
  addFiles(verb, "FILE", "weather", "of check: several answers about one place count as one", request.files)
      ->expected(0, 100);
  verb.add_flag("--json", line.asJson, "of check: as JSON");
  addFetch(verb, request);
  addText(verb, "--utc", "TIME",
          "of check: about when METARs were made, which name no month (the file's time)",
          [&request](const std::string& t) { request.utc = parseUtc(t); });
}

void WeatherFlags::addFetch(CLI::App& verb, WeatherRequest& weather) {
  forecast::FetchRequest& request = weather.fetch;
  const auto of = [&](const std::string& flag, const std::string& form, const std::string& help,
                      std::function<void(const std::string&)> read) {
    addText(verb, flag, form, "of fetch: " + help, [this, flag, read](const std::string& t) {
      fetchWords_.push_back(flag);
      read(t);
    });
  };
  of("--provider", "meteoblue|open-meteo|metar", "the service",
     [&request](const std::string& t) { request.provider = parseProvider("--provider", t); });
  of("--lat", "DEGREES", "latitude, north, -90 to 90",
     [&request](const std::string& t) { request.latitudeDegrees = number("--lat", t, -90, 90); });
  of("--lon", "DEGREES", "longitude, east, -180 to 180",
     [&request](const std::string& t) { request.longitudeDegrees = number("--lon", t, -180, 180); });
  of("--station", "ICAO", "whose METARs, such as LSZB",
     [&request](const std::string& t) { request.station = t; });
  of("--url", "URL", "another server, without ?...: https, or http of this machine",
     [&request](const std::string& t) {
       if (t.empty()) throw UsageError("--url: the address is empty");
       request.url = t;
     });
  const auto pathOf = [&](const std::string& flag, const std::string& form, const std::string& help,
                          std::optional<std::filesystem::path>& target) {
    of(flag, form, help, [flag, &target](const std::string& t) {
      if (t.empty()) throw UsageError(flag + ": the path is empty");
      target = t;
    });
  };
  pathOf("--key-file", "FILE", "the service's key, in a file of yours alone ($SKYDROP_METEOBLUE_KEY)",
         weather.keyFile);
  pathOf("--out", "FILE|-", "write the answer there too", weather.out);
}

void WeatherFlags::checkFetch(const WeatherRequest& request) const {
  const auto isGiven = [&](const char* flag) {
    return std::ranges::find(fetchWords_, flag) != fetchWords_.end();
  };
  if (request.verb != WeatherVerb::fetch) {
    if (!fetchWords_.empty()) throw UsageError(fetchWords_.front() + " belongs to weather fetch");
    return;
  }
  if (!isGiven("--provider")) throw UsageError("weather fetch: --provider is required");
  if (request.fetch.provider == forecast::Provider::metar) {
    if (!isGiven("--station")) throw UsageError("weather fetch: a METAR needs --station");
  } else if (!isGiven("--lat") || !isGiven("--lon")) {
    throw UsageError("weather fetch: --lat and --lon are required");
  }
}

void WeatherFlags::check(const CommandLine& line) const {
  if (!line.farWeatherFiles.empty() && line.weatherFiles.empty())
    throw UsageError("--weather-far needs --weather, the weather of the first site");
  const WeatherRequest& request = line.weather;
  if (line.verb != Verb::weather) return;
  checkFetch(request);
  if (request.verb == WeatherVerb::fetch && !request.files.empty())
    throw UsageError("weather fetch takes no files");
  if (request.verb == WeatherVerb::check && request.files.empty())
    throw UsageError("weather check: there is no file to check");
  if (request.verb == WeatherVerb::state && (!request.files.empty() || line.asJson || request.utc))
    throw UsageError(
        "weather state: files, --json and --utc belong to weather check; --weather FILE is flown in");
}

}  // namespace skydrop::app
