#include "fuzz/weather_input.h"

#include "skydrop/forecast/forecast_of.h"
#include "skydrop/forecast/read_report.h"

namespace skydrop::fuzz {

void readWeather(const std::uint8_t* data, std::size_t size) {
  static const sky::Instant about = sky::parseInstant("2026-06-21T13:00Z");
  const std::string text = textOf(data, size);
  accepts("a.txt", [&] {
    const forecast::Report report = forecast::readReport(text, "a.txt", about);
    require(!report.hours.empty() && report.hours.size() <= forecast::kMostHours, "a report has hours");
  });
}

}  // namespace skydrop::fuzz
