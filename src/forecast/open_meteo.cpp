// Answers of Open-Meteo with hourly values.
#include <algorithm>
#include <array>
#include <cmath>

#include "forecast/readers.h"
#include "forecast/times.h"
#include "skydrop/core/error.h"
#include "skydrop/core/json.h"

namespace skydrop::forecast {
namespace {

std::optional<double> numberOf(const nlohmann::json& root, std::string_view name, std::string_view file,
                               double least, double most) {
  const nlohmann::json* value = member(root, name);
  if (!value || value->is_null()) return std::nullopt;
  return core::jsonNumber(*value, file, name, least, most);
}

// Levels of pressure, and their heights in the standard atmosphere for files that do not have them.
struct Level {
  const char* hpa;
  double heightM;
};
constexpr std::array<Level, 9> kLevels = {{{"925", 762},
                                           {"850", 1457},
                                           {"700", 3012},
                                           {"600", 4206},
                                           {"500", 5574},
                                           {"400", 7185},
                                           {"300", 9164},
                                           {"250", 10363},
                                           {"200", 11784}}};

class Reader {
 public:
  Reader(const nlohmann::json& root, std::string_view file, Report& report)
      : table_(root, file, "hourly", "hourly_units"), file_(file), report_(report), hours_(report.hours) {
    TimeForm form;
    form.offsetHours = numberOf(root, "utc_offset_seconds", file, -64800, 64800).value_or(0) / 3600;
    form.msPerUnit = 1000;  // unixtime
    const std::vector<std::int64_t> times = readTimes(table_, form, report.notes);
    hours_.resize(times.size());
    for (std::size_t i = 0; i < times.size(); ++i) hours_[i].utcMs = times[i];
  }

  void readAll() {
    const Unit percent{0.01};
    for (const auto name : {"temperature_2m"}) readTemperature(Quantity::temperatureC, name);
    for (const auto name : {"dew_point_2m", "dewpoint_2m"}) readTemperature(Quantity::dewPointC, name);
    for (const auto name : {"relative_humidity_2m", "relativehumidity_2m"})
      table_.read(hours_, Quantity::humidity, name, percent, 0, 1.1);
    table_.read(hours_, Quantity::pressureHpa, "pressure_msl", {}, 850, 1100);
    for (const auto name : {"wind_speed_10m", "windspeed_10m"}) readSpeed(Quantity::windMps, name);
    for (const auto name : {"wind_gusts_10m", "windgusts_10m"}) readSpeed(Quantity::gustMps, name);
    for (const auto name : {"wind_direction_10m", "winddirection_10m"}) table_.readDirections(hours_, name);
    for (const auto name : {"cloud_cover", "cloudcover"})
      table_.read(hours_, Quantity::totalCover, name, percent, 0, 1.005);
    for (const auto name : {"cloud_cover_low", "cloudcover_low"})
      table_.read(hours_, Quantity::lowCover, name, percent, 0, 1.005);
    for (const auto name : {"cloud_cover_mid", "cloudcover_mid"})
      table_.read(hours_, Quantity::middleCover, name, percent, 0, 1.005);
    for (const auto name : {"cloud_cover_high", "cloudcover_high"})
      table_.read(hours_, Quantity::highCover, name, percent, 0, 1.005);
    table_.read(hours_, Quantity::visibilityM, "visibility",
                lengthUnit(table_.unitOf("visibility", "m"), file_, "hourly_units.visibility"), 0, 500'000);
    readPrecipitation();
    readCodes();
    readAloft();
  }

 private:
  void readTemperature(Quantity quantity, std::string_view name) {
    if (table_.array(name))
      table_.read(hours_, quantity, name,
                  temperatureUnit(table_.unitOf(name, "°C"), file_, "hourly_units." + std::string(name)), -90,
                  60);
  }
  void readSpeed(Quantity quantity, std::string_view name) {
    if (table_.array(name))
      table_.read(hours_, quantity, name,
                  speedUnit(table_.unitOf(name, "km/h"), file_, "hourly_units." + std::string(name)), 0, 150);
  }

  std::vector<std::optional<double>> depths(std::string_view name, std::string_view usualUnit) {
    std::vector<std::optional<double>> out(hours_.size());
    if (!table_.array(name)) return out;
    std::vector<Hour> read(hours_.size());
    table_.read(read, Quantity::precipitationMm, name,
                depthUnit(table_.unitOf(name, usualUnit), file_, "hourly_units." + std::string(name)), 0,
                1000);
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = read[i][Quantity::precipitationMm];
    return out;
  }

  // Snow is given as its depth: 7 cm of it are 10 mm of water (Open-Meteo's documentation).
  void readPrecipitation() {
    constexpr double kWaterOfSnow = 1 / 7.0;
    const auto all = depths("precipitation", "mm"), rain = depths("rain", "mm"),
               showers = depths("showers", "mm"), snow = depths("snowfall", "cm");
    for (std::size_t i = 0; i < hours_.size(); ++i) {
      std::optional<double> snowWater = snow[i];
      if (snowWater) *snowWater *= kWaterOfSnow;
      std::optional<double> total = all[i];
      if (!total && (rain[i] || showers[i] || snowWater))
        total = rain[i].value_or(0) + showers[i].value_or(0) + snowWater.value_or(0);
      hours_[i][Quantity::precipitationMm] = total;
      if (showers[i] && total) hours_[i][Quantity::convectiveMm] = std::min(*showers[i], *total);
      if (snowWater && total && *total > 0)
        hours_[i][Quantity::snowShare] = std::clamp(*snowWater / *total, 0.0, 1.0);
    }
  }

  void readCodes() {
    const std::string name = table_.first({"weather_code", "weathercode"});
    const nlohmann::json* codes = name.empty() ? nullptr : table_.array(name);
    if (!codes) return;
    for (std::size_t i = 0; i < hours_.size(); ++i) {
      if ((*codes)[i].is_null()) continue;
      const double code = core::jsonWhole((*codes)[i], file_, table_.placeOf(name, i), 0, 99);
      hours_[i].phenomena = phenomenaOfWmoCode(static_cast<int>(code));
    }
  }

  void readAloft() {
    for (const Level& level : kLevels) {
      const std::string end = std::string("_") + level.hpa + "hPa";
      if (table_.first({"wind_speed" + end, "windspeed" + end}).empty()) continue;
      std::vector<Hour> read(hours_.size());
      for (const std::string& name : {"wind_speed" + end, "windspeed" + end}) {
        if (table_.array(name))
          table_.read(read, Quantity::windMps, name,
                      speedUnit(table_.unitOf(name, "km/h"), file_, "hourly_units." + name), 0, 150);
      }
      for (const std::string& name : {"wind_direction" + end, "winddirection" + end})
        table_.readDirections(read, name);
      const Unit metres;
      table_.read(read, Quantity::visibilityM, "geopotential_height" + end, metres, -500, 20000);
      for (std::size_t i = 0; i < hours_.size(); ++i) {
        const std::optional<double> speed = read[i][Quantity::windMps], from = read[i][Quantity::windFromDeg];
        if (!speed || !from) continue;
        const WindAloft wind{read[i][Quantity::visibilityM].value_or(level.heightM), *speed, *from};
        std::vector<WindAloft>& aloft = hours_[i].aloft;
        if (aloft.empty() || wind.heightM > aloft.back().heightM) aloft.push_back(wind);
      }
    }
  }

  HourlyTable table_;
  std::string_view file_;
  Report& report_;
  std::vector<Hour>& hours_;
};

}  // namespace

Phenomena phenomenaOfWmoCode(int code) {
  Phenomena out;
  out.thunder = code == 17 || code == 29 || code >= 95;
  out.hail = code == 96 || code == 99 || code == 27 || code == 89 || code == 90;
  out.towers = out.thunder || (code >= 80 && code <= 90);
  out.fog = code >= 40 && code <= 49;
  return out;
}

Report readOpenMeteo(const nlohmann::json& root, std::string_view file) {
  Report report;
  report.provider = Provider::openMeteo;
  report.file = file;
  report.latitudeDegrees = numberOf(root, "latitude", file, -90, 90);
  report.longitudeDegrees = numberOf(root, "longitude", file, -180, 360);
  report.elevationM = numberOf(root, "elevation", file, -430, 8848).value_or(0);
  Reader(root, file, report).readAll();
  return report;
}

}  // namespace skydrop::forecast
