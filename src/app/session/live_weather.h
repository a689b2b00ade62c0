// The start of a flight in the weather of a service: the answer that is flown in at first, and what renews
// it.
#pragma once

#include <string>
#include <vector>

#include "app/types/command_line.h"
#include "skydrop/forecast/renewal.h"

namespace skydrop::app {

struct LiveWeather {
  std::filesystem::path file;    // the newest answer; empty: none is kept, nor was one needed
  forecast::RenewalSetup setup;  // for forecast::Renewal
  std::vector<std::string> notes;
};

// The newest answer in the cache folder, with its age as a note. Where there is none, and no file of the
// command line to begin with, the service is asked, which takes up to 12 s. Throws core::UsageError,
// core::DataError.
LiveWeather liveWeather(const LiveRequest& request, bool needsAnswer);

}  // namespace skydrop::app
