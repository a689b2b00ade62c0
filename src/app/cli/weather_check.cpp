// skydrop weather check: what weather files say, hour by hour, what they lack, and what is made of it.
#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/cli/verbs.h"
#include "app/cli/weather_json.h"
#include "app/console/standard_output.h"
#include "skydrop/core/message.h"
#include "skydrop/forecast/forecast_of.h"
#include "skydrop/forecast/read_report.h"
#include "skydrop/sky/instant.h"

namespace skydrop::app {
namespace {

using Json = nlohmann::ordered_json;
using forecast::Hour;
using forecast::Quantity;
using forecast::Report;

std::string text(const char* form, double value) {
  std::array<char, 48> out{};
  std::snprintf(out.data(), out.size(), form, value);
  return out.data();
}

std::string cell(const std::optional<double>& value, const char* form, double factor = 1) {
  return value ? text(form, *value * factor) : "-";
}

std::string layersText(const weather::State& state) {
  std::string out;
  for (const weather::Layer& layer : state.layers) {
    if (!(layer.cover > 0)) continue;
    out += (out.empty() ? "" : ", ") +
           std::string(weather::kGenusNames[static_cast<std::size_t>(layer.genus)]) +
           text(" %.0f", layer.baseM) + text("-%.0f m", layer.topM) + text(" %.0f%%", layer.cover * 100);
  }
  return out.empty() ? "no clouds" : out;
}

std::string rainText(const weather::State& state) {
  std::string out;
  const auto add = [&](const char* what, double rate) {
    if (rate > 0) out += std::string(", ") + what + text(" %.1f mm/h", rate);
  };
  add("rain", state.precipitation.rain);
  add("snow", state.precipitation.snow);
  add("sleet", state.precipitation.sleet);
  add("hail", state.precipitation.hail);
  if (state.lightningPerMinute > 0) out += ", thunder";
  if (state.fog.extinction > 0) out += text(", fog to %.0f m", state.fog.topM);
  return out;
}

void printHour(const Hour& given, const Hour& filled, const forecast::Ground& ground) {
  const weather::State state = forecast::stateOf(filled, ground);
  std::string phenomena;
  if (given.phenomena) {
    if (given.phenomena->thunder) phenomena += " thunder";
    if (given.phenomena->hail) phenomena += " hail";
    if (given.phenomena->towers && !given.phenomena->thunder) phenomena += " showers";
    if (given.phenomena->fog) phenomena += " fog";
  }
  std::string sky = cell(given[Quantity::lowCover], "%.0f", 100) + "/" +
                    cell(given[Quantity::middleCover], "%.0f", 100) + "/" +
                    cell(given[Quantity::highCover], "%.0f", 100) + " of " +
                    cell(given[Quantity::totalCover], "%.0f%%", 100);
  print("%s  %5s C  %3s deg %5s m/s  %5s mm  %-20s%s\n    %s%s\n", sky::instantText({given.utcMs}).c_str(),
        cell(given[Quantity::temperatureC], "%.1f").c_str(),
        cell(given[Quantity::windFromDeg], "%.0f").c_str(), cell(given[Quantity::windMps], "%.1f").c_str(),
        cell(given[Quantity::precipitationMm], "%.1f").c_str(), sky.c_str(), phenomena.c_str(),
        layersText(state).c_str(), rainText(state).c_str());
}

std::string placeText(const Report& report) {
  std::string out = report.place.empty() ? "" : core::printable(report.place) + ", ";
  if (report.latitudeDegrees && report.longitudeDegrees)
    out += text("%.3f north ", *report.latitudeDegrees) + text("%.3f east, ", *report.longitudeDegrees);
  return out + text("%.0f m", report.elevationM);
}

void printText(const Report& report, const Report& filled) {
  print("%s: %s, %s\n", core::printable(report.file).c_str(),
        std::string(forecast::kProviderNames[static_cast<std::size_t>(report.provider)]).c_str(),
        placeText(report).c_str());
  print("%zu hours, %s to %s\n", report.hours.size(), sky::instantText({report.hours.front().utcMs}).c_str(),
        sky::instantText({report.hours.back().utcMs}).c_str());
  for (const std::string& note : report.notes) print("note: %s\n", core::printable(note).c_str());
  for (const forecast::Missing& missing : forecast::missingIn(report)) {
    const std::string name(forecast::kQuantityNames[static_cast<std::size_t>(missing.quantity)]);
    if (missing.hours == report.hours.size())
      print("missing: %s\n", name.c_str());
    else
      print("missing: %s in %zu hours, taken from those around them\n", name.c_str(), missing.hours);
  }
  print(
      "time, temperature, wind from and speed, precipitation, cover low/middle/high of total; what is flown "
      "in\n");
  for (std::size_t i = 0; i < report.hours.size(); ++i)
    printHour(report.hours[i], filled.hours[i], forecast::groundOf(report));
}

Json hourJson(const Hour& given, const Hour& filled, const forecast::Ground& ground) {
  Json said = Json::object();
  for (std::size_t q = 0; q < forecast::kQuantities; ++q) {
    if (given.values[q]) said[std::string(forecast::kQuantityNames[q])] = *given.values[q];
  }
  Json out = {{"utc", sky::instantText({given.utcMs})}, {"said", said}};
  if (given.phenomena)
    out["phenomena"] = {{"thunder", given.phenomena->thunder},
                        {"hail", given.phenomena->hail},
                        {"towers", given.phenomena->towers},
                        {"fog", given.phenomena->fog}};
  if (!given.aloft.empty()) {
    out["aloft"] = Json::array();
    for (const auto& wind : given.aloft)
      out["aloft"].push_back(
          {{"heightM", wind.heightM}, {"speedMps", wind.speedMps}, {"directionDeg", wind.fromDeg}});
  }
  if (given.layers) {
    out["seen"] = Json::array();
    for (const auto& layer : *given.layers)
      out["seen"].push_back({{"cover", layer.cover},
                             {"baseAboveGroundM", layer.baseM},
                             {"cumulonimbus", layer.cumulonimbus},
                             {"toweringCumulus", layer.toweringCumulus}});
  }
  out["near"] = stateJson(forecast::stateOf(filled, ground));
  out["far"] = stateJson(forecast::farStateOf(filled, ground));
  return out;
}

Json reportJson(const Report& report, const Report& filled) {
  const auto number = [](const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); };
  Json missing = Json::object(), hours = Json::array();
  for (const forecast::Missing& m : forecast::missingIn(report))
    missing[std::string(forecast::kQuantityNames[static_cast<std::size_t>(m.quantity)])] = m.hours;
  for (std::size_t i = 0; i < report.hours.size(); ++i)
    hours.push_back(hourJson(report.hours[i], filled.hours[i], forecast::groundOf(report)));
  return {{"schema", 1},
          {"file", core::printable(report.file)},
          {"provider", forecast::kProviderNames[static_cast<std::size_t>(report.provider)]},
          {"place", core::printable(report.place)},
          {"latitudeDegrees", number(report.latitudeDegrees)},
          {"longitudeDegrees", number(report.longitudeDegrees)},
          {"elevationM", report.elevationM},
          {"notes", report.notes},
          {"missingHours", missing},
          {"hours", hours}};
}

}  // namespace

int checkWeather(const CommandLine& line) {
  std::vector<Report> reports;
  for (const std::filesystem::path& file : line.weather.files)
    reports.push_back(forecast::readReportFile(file, line.weather.utc).report);
  const Report report = forecast::merged(std::move(reports));
  Report filled = report;
  forecast::fillGaps(filled);
  if (line.asJson)
    print("%s\n", reportJson(report, filled).dump(2, ' ', false, Json::error_handler_t::replace).c_str());
  else
    printText(report, filled);
  return 0;
}

}  // namespace skydrop::app
