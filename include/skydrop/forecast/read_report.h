// Weather files of others as reports: answers of meteoblue (packages basic-1h and clouds-1h, combined or
// one), answers of Open-Meteo with hourly values, and METAR or SPECI. They are recognised by their content.
// Any thread; pure.
//
// What is damaged or foreign is a core::DataError of one line with file, place ("data_1h.lowclouds[17]") and
// reason. Refused, never guessed: units that are not known, numbers out of any weather's range, arrays of
// different lengths, times that do not ascend. Taken, and noted: nulls, arrays that are missing, a clock that
// was put forward or back within local times.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "skydrop/forecast/report.h"
#include "skydrop/sky/instant.h"

namespace skydrop::forecast {

inline constexpr std::size_t kMostBytes = std::size_t{8} << 20;
inline constexpr std::size_t kMostHours = 10'000;

// `about`: an instant near the time at which the reports were made; a METAR names a day of the month alone
// and is dated within half a month of it, unless lines of the file give the date.
Report readReport(std::string_view text, std::string_view file, sky::Instant about);

// Several answers about one place as one: of each hour what the first has, and from the others what it lacks.
Report merged(std::vector<Report> reports);

}  // namespace skydrop::forecast
