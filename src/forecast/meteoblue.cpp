// Answers of meteoblue, packages basic-1h and clouds-1h.
#include <cmath>

#include "forecast/readers.h"
#include "forecast/times.h"
#include "skydrop/core/error.h"
#include "skydrop/core/json.h"

namespace skydrop::forecast {
namespace {

std::optional<double> numberOf(const nlohmann::json* object, std::string_view name, std::string_view file,
                               double least, double most) {
  const nlohmann::json* value = object ? member(*object, name) : nullptr;
  if (!value || value->is_null()) return std::nullopt;
  return core::jsonNumber(*value, file, "metadata." + std::string(name), least, most);
}

void readPhenomena(const HourlyTable& table, std::vector<Hour>& hours) {
  const nlohmann::json* codes = table.array("pictocode");
  if (!codes) return;
  for (std::size_t i = 0; i < hours.size(); ++i) {
    if ((*codes)[i].is_null()) continue;
    const double code = core::jsonWhole((*codes)[i], table.file(), table.placeOf("pictocode", i), 1, 35);
    hours[i].phenomena = phenomenaOfPictocode(static_cast<int>(code));
  }
}

}  // namespace

Phenomena phenomenaOfPictocode(int code) {
  Phenomena out;
  out.thunder = code == 27 || code == 28 || code == 30;
  out.towers = out.thunder || code == 29 || (code >= 10 && code <= 12) || code == 31 || code == 32;
  out.fog = code >= 16 && code <= 18;
  return out;
}

Report readMeteoblue(const nlohmann::json& root, std::string_view file) {
  Report report;
  report.provider = Provider::meteoblue;
  report.file = file;
  const HourlyTable table(root, file, "data_1h", "units");
  const nlohmann::json* metadata = member(root, "metadata");
  if (const nlohmann::json* name = metadata ? member(*metadata, "name") : nullptr; name && name->is_string())
    report.place = name->get<std::string>();
  report.latitudeDegrees = numberOf(metadata, "latitude", file, -90, 90);
  report.longitudeDegrees = numberOf(metadata, "longitude", file, -180, 360);
  report.elevationM = numberOf(metadata, "height", file, -430, 8848).value_or(0);
  const std::optional<double> offset = numberOf(metadata, "utc_timeoffset", file, -18, 18);

  TimeForm form;
  form.offsetHours = offset.value_or(0);
  const std::string timeUnit = table.unitOf("time", "");
  if (timeUnit.starts_with("seconds since")) form.msPerUnit = 1000;
  const std::vector<std::int64_t> times = readTimes(table, form, report.notes);
  if (!offset && timeUnit == "YYYY-MM-DD hh:mm")
    report.notes.emplace_back("metadata.utc_timeoffset is missing: its times are taken as UTC");
  report.hours.resize(times.size());
  for (std::size_t i = 0; i < times.size(); ++i) report.hours[i].utcMs = times[i];

  std::vector<Hour>& hours = report.hours;
  const auto percent = Unit{0.01};
  const Unit depth = depthUnit(table.unitOf("precipitation", "mm"), file, "units.precipitation");
  const Unit speed = speedUnit(table.unitOf("windspeed", "ms-1"), file, "units.windspeed");
  table.read(hours, Quantity::temperatureC, "temperature",
             temperatureUnit(table.unitOf("temperature", "C"), file, "units.temperature"), -90, 60);
  table.read(hours, Quantity::humidity, "relativehumidity", percent, 0, 1.1);
  table.read(hours, Quantity::pressureHpa, "sealevelpressure", {}, 850, 1100);
  table.read(hours, Quantity::windMps, "windspeed", speed, 0, 110);
  table.read(hours, Quantity::gustMps, "gust", speed, 0, 150);
  table.readDirections(hours, "winddirection");
  table.read(hours, Quantity::precipitationMm, "precipitation", depth, 0, 400);
  table.read(hours, Quantity::convectiveMm, "convective_precipitation", depth, 0, 400);
  table.read(hours, Quantity::snowShare, "snowfraction", {}, 0, 1);
  table.read(hours, Quantity::totalCover, "totalcloudcover", percent, 0, 1.005);
  table.read(hours, Quantity::lowCover, "lowclouds", percent, 0, 1.005);
  table.read(hours, Quantity::middleCover, "midclouds", percent, 0, 1.005);
  table.read(hours, Quantity::highCover, "highclouds", percent, 0, 1.005);
  table.read(hours, Quantity::visibilityM, "visibility",
             lengthUnit(table.unitOf("visibility", "m"), file, "units.visibility"), 0, 500'000);
  table.read(hours, Quantity::fogProbability, "fog_probability", percent, 0, 1.005);
  readPhenomena(table, hours);
  return report;
}

}  // namespace skydrop::forecast
