// From reports to weather: the state of the air that an hour's figures stand for (docs/forecasts.md has the
// rules and their reasons). Pure; the same bits on every machine.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "skydrop/forecast/report.h"
#include "skydrop/sky/instant.h"
#include "skydrop/weather/forecast.h"

namespace skydrop::forecast {

// Of the place that a report is about.
struct Ground {
  double elevationM = 0;  // above the sea
  bool isSouthern = false;
};
Ground groundOf(const Report& report);

// The state of an hour. Usable (weather::requireUsable()).
weather::State stateOf(const Hour& hour, const Ground& ground);

// The same sky with the covers of its layers changed in equal measure, until together, overlapping at random,
// they cover as much as the hour's total: what is seen far away. Without a total the state itself.
weather::State farStateOf(const Hour& hour, const Ground& ground);

// The far report is that of a second site; without one it is made of the near one's total cover. Gaps are
// filled before. Throws core::DataError.
weather::Forecast forecastOf(Report near, std::optional<Report> far, std::uint64_t digest);

// Files, read and put together.
struct FileForecast {
  std::shared_ptr<const weather::Forecast> forecast;
  std::vector<std::uint64_t> nearDigests, farDigests;  // of each file
  std::vector<std::string> notes;                      // lines about what was understood with a doubt
};
using Files = std::vector<std::filesystem::path>;  // several answers about one place
// A METAR is dated by `about`, or else by the time at which its file was written. Throws core::DataError.
FileForecast readForecast(const Files& near, const Files& far, std::optional<sky::Instant> about);

// Of the content of a file.
std::uint64_t contentDigest(std::string_view text);

// One file.
struct FileReport {
  Report report;
  std::uint64_t digest = 0;  // of its content
};
// A METAR as readForecast() dates it. Throws core::DataError.
FileReport readReportFile(const std::filesystem::path& file, std::optional<sky::Instant> about);

}  // namespace skydrop::forecast
