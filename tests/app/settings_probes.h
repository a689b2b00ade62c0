// What simulation, land, loudspeaker and interface make of a row of the settings, as a number to compare.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "app/settings/settings.h"

namespace skydrop::app {

struct Probe {
  std::string_view rows;  // a path, or the beginning of one
  std::uint64_t (*observe)(const Settings&);
  std::vector<std::string> given = {};  // what has to be set before the row means anything
};

// Of a row the first that fits.
const std::vector<Probe>& settingsProbes();

}  // namespace skydrop::app
