// Weather files from services, by HTTP through libcurl. Blocks: for a worker or the command line, never for
// the thread that draws. Certificates are checked; plain http is taken for this machine alone. The key of a
// service is in no message.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

#include "skydrop/forecast/report.h"

namespace skydrop::forecast {

struct FetchRequest {
  Provider provider = Provider::openMeteo;
  double latitudeDegrees = 0, longitudeDegrees = 0;  // of a METAR they count for nothing
  std::string station;                               // of a METAR: four letters or digits of ICAO
  std::string url;  // of another server, up to its query; empty: the provider's own
  std::string key;  // of meteoblue
};

struct FetchLimits {
  double connectS = 10, stallS = 10, totalS = 30;  // to connect, without a byte, and in all, of one attempt
  std::size_t bytes = std::size_t{8} << 20;        // after decompression
  int redirects = 3;
  int attempts = 3;             // after failures that may pass: no connection, 429, 5xx
  double backOffS = 1;          // before the second attempt; doubled before each further one
  double longestBackOffS = 30;  // also where the server asks for more
};

// What tells a server which file one has already.
struct Validators {
  std::string etag, lastModified;
};

struct Fetched {
  std::string body;
  Validators validators;
  bool notModified = false;  // 304: the file that one has is the newest; there is no body
};

// The whole address. Throws core::RangeError where the request lacks something: a station, a key, an address
// that is neither https nor http of this machine.
std::string addressOf(const FetchRequest& request);

// Throws core::DataError of one line that names server and path without what follows "?"; so it does within
// milliseconds of a request to stop, whatever it waits for.
Fetched fetch(const FetchRequest& request, const Validators& known, const FetchLimits& limits = {},
              const std::stop_token& stop = {});

// The key of a service: from the environment variable SKYDROP_METEOBLUE_KEY, or the first line of a file
// that its owner alone may read. Throws core::DataError; it never says what is in the file.
std::string readKey(const std::optional<std::filesystem::path>& file);

}  // namespace skydrop::forecast
