#include "skydrop/forecast/read_report.h"

#include <algorithm>
#include <map>
#include <utility>

#include "forecast/readers.h"
#include "skydrop/core/error.h"
#include "skydrop/core/json.h"

namespace skydrop::forecast {
namespace {

constexpr core::JsonLimits kLimits = {.bytes = kMostBytes, .depth = 16, .values = 1'000'000};

// A service that refused, and says so in its answer.
[[noreturn]] void passOn(const nlohmann::json& root, std::string_view file, std::string_view name) {
  const nlohmann::json& reason = root.at(std::string(name));
  throw core::DataError(file, name,
                        "is the error answer of a service: " +
                            (reason.is_string() ? reason.get<std::string>() : reason.dump()));
}

Report readJsonReport(std::string_view text, std::string_view file) {
  const nlohmann::json root = core::parseJson(text, file, kLimits);
  if (root.is_array()) throw core::DataError(file, "", "is a list of answers: ask for one place at a time");
  if (root.contains("reason") && root.value("error", nlohmann::json()) == true) passOn(root, file, "reason");
  if (root.contains("error_message")) passOn(root, file, "error_message");
  if (root.contains("data_1h") || root.contains("metadata")) return readMeteoblue(root, file);
  if (root.contains("hourly") || root.contains("hourly_units")) return readOpenMeteo(root, file);
  throw core::DataError(file, "", "is no answer of meteoblue (data_1h) or Open-Meteo (hourly)");
}

}  // namespace

Report readReport(std::string_view text, std::string_view file, sky::Instant about) {
  if (text.size() > kMostBytes)
    throw core::DataError(file, "size", "more than " + std::to_string(kMostBytes) + " bytes");
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  const bool isJson = start == std::string_view::npos || text[start] == '{' || text[start] == '[' ||
                      static_cast<unsigned char>(text[start]) >= 0x80;  // a byte order mark
  Report report;
  if (isJson)
    report = readJsonReport(text, file);
  else if (looksLikeMetar(text))
    report = readMetar(text, file, about);
  else
    throw core::DataError(file, "line 1", "is neither an answer of meteoblue or Open-Meteo nor a METAR");
  bool hasAny = false;
  for (const Hour& hour : report.hours)
    hasAny = hasAny || hour.layers || hour.phenomena || !hour.aloft.empty() ||
             std::ranges::any_of(hour.values, [](const auto& value) { return value.has_value(); });
  if (!hasAny) throw core::DataError(file, "", "none of its hours says anything of the weather");
  return report;
}

Report merged(std::vector<Report> reports) {
  Report out = std::move(reports.front());
  std::map<std::int64_t, Hour> hours;
  for (Hour& hour : out.hours) hours.emplace(hour.utcMs, std::move(hour));
  for (std::size_t i = 1; i < reports.size(); ++i) {
    Report& other = reports[i];
    for (Hour& hour : other.hours) {
      const auto [at, isNew] = hours.try_emplace(hour.utcMs, hour);
      if (isNew) continue;
      Hour& target = at->second;
      for (std::size_t q = 0; q < kQuantities; ++q) {
        if (!target.values[q]) target.values[q] = hour.values[q];
      }
      if (!target.phenomena) target.phenomena = hour.phenomena;
      if (!target.layers) target.layers = std::move(hour.layers);
      if (target.aloft.empty()) target.aloft = std::move(hour.aloft);
    }
    out.notes.insert(out.notes.end(), other.notes.begin(), other.notes.end());
  }
  out.hours.clear();
  for (auto& [ms, hour] : hours) out.hours.push_back(std::move(hour));
  return out;
}

}  // namespace skydrop::forecast
