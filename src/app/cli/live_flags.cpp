#include "app/cli/live_flags.h"

#include <CLI/CLI.hpp>
#include <functional>

#include "app/cli/flag_options.h"
#include "app/cli/flag_values.h"
#include "skydrop/core/error.h"

namespace skydrop::app {

using core::UsageError;

void LiveFlags::add(CLI::App& verb, CommandLine& line) {
  addText(verb, "--live", "meteoblue|open-meteo|metar",
          "fly in the weather of a service, which is asked again while flying (--set live.renewMinutes=60); "
          "offline in its newest answer",
          [this, &line](const std::string& t) {
            if (!line.live) line.live.emplace();
            line.live->fetch.provider = parseProvider("--live", t);
            hasProvider_ = true;
          });
  const auto of = [&](const std::string& flag, const std::string& form, const std::string& help,
                      std::function<void(const std::string&, LiveRequest&)> read) {
    addText(verb, flag, form, "of --live: " + help, [this, &line, flag, read](const std::string& t) {
      words_.push_back(flag);
      LiveRequest& request = line.live ? *line.live : line.live.emplace();
      read(t, request);
    });
  };
  of("--live-at", "LAT,LON", "the place, degrees north and east",
     [this](const std::string& t, LiveRequest& request) {
       const std::size_t comma = t.find(',');
       if (comma == std::string::npos) throw UsageError("--live-at: '" + t + "' is not LAT,LON");
       request.fetch.latitudeDegrees = number("--live-at", t.substr(0, comma), -90, 90);
       request.fetch.longitudeDegrees = number("--live-at", t.substr(comma + 1), -180, 180);
       hasPlace_ = true;
     });
  of("--live-station", "ICAO", "whose METARs, such as LSZB",
     [](const std::string& t, LiveRequest& request) { request.fetch.station = t; });
  of("--live-url", "URL", "another server, without ?...: https, or http of this machine",
     [](const std::string& t, LiveRequest& request) {
       if (t.empty()) throw UsageError("--live-url: the address is empty");
       request.fetch.url = t;
     });
  of("--live-key-file", "FILE", "the service's key, in a file of yours alone ($SKYDROP_METEOBLUE_KEY)",
     [](const std::string& t, LiveRequest& request) {
       if (t.empty()) throw UsageError("--live-key-file: the path is empty");
       request.keyFile = t;
     });
}

void LiveFlags::check(const CommandLine& line) const {
  if (!line.live) return;
  if (!hasProvider_) throw UsageError(words_.front() + " belongs to --live, which is not given");
  if (line.verb != Verb::fly) throw UsageError("--live belongs to a flight in the window");
  if (line.record || line.replay)
    throw UsageError("--live excludes --record and --replay: a flight is recorded in one forecast");
  if (line.live->fetch.provider == forecast::Provider::metar) {
    if (line.live->fetch.station.empty()) throw UsageError("--live metar needs --live-station");
  } else if (!hasPlace_) {
    throw UsageError("--live needs --live-at, the place that the forecast is for");
  }
}

}  // namespace skydrop::app
