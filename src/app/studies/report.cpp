#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/studies/study.h"

namespace skydrop::app {
namespace {

constexpr int kSchema = 1;
constexpr int kShownDigits = 3, kAllDigits = 17;

// Whether `other` is at least as good in everything and better in something.
bool dominates(const StudyRow& other, const StudyRow& row) {
  bool better = other.cost < row.cost;
  if (other.cost > row.cost) return false;
  for (std::size_t i = 0; i < row.errors.size(); ++i) {
    if (other.errors[i] > row.errors[i]) return false;
    better = better || other.errors[i] < row.errors[i];
  }
  return better;
}

// NaN: there is no such value.
std::string inText(double value, int digits) {
  if (std::isnan(value)) return "";
  std::ostringstream out;
  out.precision(digits);
  out << value;
  return out.str();
}

// Counts and bytes whole, measured values to three digits.
std::string shownNumber(double value) {
  constexpr double kDigitsEnd = 1000;
  if (!(std::abs(value) >= kDigitsEnd)) return inText(value, kShownDigits);
  return std::to_string(std::llround(value));
}

void writeMarkdown(std::ostream& out, const StudyResult& result) {
  out << "## " << result.title << "\n\n" << result.method << "\n\n";
  out << "Timed by " << result.cost.clock << " on " << result.machine << ".\n\n";
  out << "| |";
  for (const StudyMetric& metric : result.metrics)
    out << " " << metric.name << (metric.unit.empty() ? "" : ", ") << metric.unit << " |";
  if (result.isTradeOff) out << " " << result.cost.unit << " | Pareto-optimal |";
  out << " |\n|---|";
  for (std::size_t i = 0; i < result.metrics.size(); ++i) out << "---|";
  out << (result.isTradeOff ? "---|---|---|\n" : "---|\n");
  for (const StudyRow& row : result.rows) {
    out << "| " << row.label << " |";
    for (const double error : row.errors)
      out << " " << (result.isTradeOff ? inText(error, kShownDigits) : shownNumber(error)) << " |";
    if (result.isTradeOff)
      out << " " << inText(row.cost, kShownDigits) << " | "
          << (isParetoOptimal(row, result.rows) ? "yes" : "") << " |";
    out << " " << row.note << " |\n";
  }
  out << "\n";
}

std::string markdown(const std::vector<StudyResult>& results, const ReportHeading& heading) {
  std::ostringstream out;
  out << "# " << heading.title << "\n\n" << heading.introduction << "\n\n";
  for (const StudyResult& result : results) writeMarkdown(out, result);
  return out.str();
}

std::string json(const std::vector<StudyResult>& results) {
  nlohmann::ordered_json studies = nlohmann::ordered_json::array();
  for (const StudyResult& result : results) {
    nlohmann::ordered_json metrics = nlohmann::ordered_json::array(), rows = nlohmann::ordered_json::array();
    for (const StudyMetric& metric : result.metrics) {
      metrics.push_back({{"name", metric.name}, {"unit", metric.unit}});
    }
    for (const StudyRow& row : result.rows) {
      if (!result.isTradeOff) {
        rows.push_back({{"label", row.label}, {"values", row.errors}, {"note", row.note}});
        continue;
      }
      rows.push_back({{"label", row.label},
                      {"errors", row.errors},
                      {"cost", row.cost},
                      {"paretoOptimal", isParetoOptimal(row, result.rows)},
                      {"note", row.note}});
    }
    nlohmann::ordered_json study = {{"title", result.title},
                                    {"method", result.method},
                                    {"machine", result.machine},
                                    {"metrics", metrics}};
    if (result.isTradeOff) {
      study["cost"] = {{"unit", result.cost.unit}, {"clock", result.cost.clock}};
    } else {
      study["clock"] = result.cost.clock;
    }
    study["rows"] = rows;
    studies.push_back(study);
  }
  return nlohmann::ordered_json{{"schema", kSchema}, {"studies", studies}}.dump(2) + "\n";
}

// A field of RFC 4180.
std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string field = "\"";
  for (const char c : text) field += c == '"' ? "\"\"" : std::string(1, c);
  return field + "\"";
}

std::string csv(const std::vector<StudyResult>& results) {
  std::string out = "study,label,metric,unit,error,cost,costUnit,clock,paretoOptimal,note\r\n";
  for (const StudyResult& result : results) {
    for (const StudyRow& row : result.rows) {
      for (std::size_t i = 0; i < result.metrics.size(); ++i) {
        const StudyMetric& metric = result.metrics[i];
        out += quoted(result.title) + "," + quoted(row.label) + "," + quoted(metric.name) + "," +
               quoted(metric.unit) + "," + inText(row.errors[i], kAllDigits) + "," +
               (result.isTradeOff ? inText(row.cost, kAllDigits) : "") + "," + quoted(result.cost.unit) +
               "," + quoted(result.cost.clock) + "," +
               (!result.isTradeOff                  ? ""
                : isParetoOptimal(row, result.rows) ? "yes"
                                                    : "no") +
               "," + quoted(row.note) + "\r\n";
      }
    }
  }
  return out;
}

}  // namespace

bool isParetoOptimal(const StudyRow& row, const std::vector<StudyRow>& rows) {
  return std::none_of(rows.begin(), rows.end(), [&](const StudyRow& other) { return dominates(other, row); });
}

std::string studyReport(const std::vector<StudyResult>& results, ReportFormat format,
                        const ReportHeading& heading) {
  switch (format) {
    case ReportFormat::json:
      return json(results);
    case ReportFormat::csv:
      return csv(results);
    case ReportFormat::markdown:
      break;
  }
  return markdown(results, heading);
}

}  // namespace skydrop::app
