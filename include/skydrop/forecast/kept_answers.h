// Answers of weather services that are kept in a folder, each with the time at which it was fetched and with
// what the server wants to be asked by the next time. One process at a time renews an answer; a file that was
// half written is never seen.
#pragma once

#include <filesystem>
#include <optional>

#include "skydrop/forecast/fetch.h"
#include "skydrop/sky/instant.h"

namespace skydrop::forecast {

struct KeptAnswer {
  std::filesystem::path file;
  sky::Instant fetched;
  Validators validators;
};

// The newest answer to a request (its key does not count), if there is a whole one.
std::optional<KeptAnswer> keptAnswer(const std::filesystem::path& folder, const FetchRequest& request);

// Asks the server whether there is a newer one, reads it, and keeps it if it is weather. Throws
// core::DataError, and core::RangeError as addressOf(); what was kept stays. `stop`: as in fetch().
KeptAnswer renew(const std::filesystem::path& folder, const FetchRequest& request, sky::Instant now,
                 const FetchLimits& limits = {}, const std::stop_token& stop = {});

}  // namespace skydrop::forecast
