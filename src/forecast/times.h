// The times of an hourly table as instants.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "forecast/hourly_table.h"

namespace skydrop::forecast {

struct TimeForm {
  double offsetHours = 0;  // of the local clock, ahead of UTC, for texts without a zone
  double msPerUnit = 1;    // of numbers
};

// Milliseconds since 1970, strictly ascending. Local times of an hourly table follow a clock that is put
// forward or back once: an hour that comes twice, or one that is missing in a month in which clocks are put
// forward while no other is; a note says so. Throws core::DataError.
std::vector<std::int64_t> readTimes(const HourlyTable& table, const TimeForm& form,
                                    std::vector<std::string>& notes);

}  // namespace skydrop::forecast
