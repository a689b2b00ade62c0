// The record as a value, for the file of its own and as a part of others.
#pragma once

#include <nlohmann/json.hpp>

#include "skydrop/stability/hard_case.h"

namespace skydrop::stability {

nlohmann::ordered_json jsonOf(const HardCaseRecord& record);

}  // namespace skydrop::stability
