// The state of the air as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "skydrop/weather/state.h"

namespace skydrop::app {

nlohmann::ordered_json stateJson(const weather::State& state);

}  // namespace skydrop::app
