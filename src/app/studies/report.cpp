#include <algorithm>
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

std::string inText(double value, int digits) {
  std::ostringstream out;
  out.precision(digits);
  out << value;
  return out.str();
}

void writeMarkdown(std::ostream& out, const StudyResult& result) {
  out << "## " << result.title << "\n\n" << result.method << "\n\n";
  out << "Timed by " << result.cost.clock << " on " << result.machine << ".\n\n";
  out << "| |";
  for (const StudyMetric& metric : result.metrics) out << " " << metric.name << ", " << metric.unit << " |";
  out << " " << result.cost.unit << " | Pareto-optimal | |\n|---|";
  for (std::size_t i = 0; i < result.metrics.size(); ++i) out << "---|";
  out << "---|---|---|\n";
  for (const StudyRow& row : result.rows) {
    out << "| " << row.label << " |";
    for (const double error : row.errors) out << " " << inText(error, kShownDigits) << " |";
    out << " " << inText(row.cost, kShownDigits) << " | " << (isParetoOptimal(row, result.rows) ? "yes" : "")
        << " | " << row.note << " |\n";
  }
  out << "\n";
}

std::string markdown(const std::vector<StudyResult>& results) {
  std::ostringstream out;
  out << "# What accuracy costs\n\n"
         "Each table turns one parameter: its error against a converged reference, and its cost. A row is "
         "Pareto-optimal\n"
         "when no other row is both cheaper and more accurate. Made by `skydrop accuracy`.\n\n";
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
      rows.push_back({{"label", row.label},
                      {"errors", row.errors},
                      {"cost", row.cost},
                      {"paretoOptimal", isParetoOptimal(row, result.rows)},
                      {"note", row.note}});
    }
    studies.push_back({{"title", result.title},
                       {"method", result.method},
                       {"machine", result.machine},
                       {"metrics", metrics},
                       {"cost", {{"unit", result.cost.unit}, {"clock", result.cost.clock}}},
                       {"rows", rows}});
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
               inText(row.cost, kAllDigits) + "," + quoted(result.cost.unit) + "," +
               quoted(result.cost.clock) + "," + (isParetoOptimal(row, result.rows) ? "yes" : "no") + "," +
               quoted(row.note) + "\r\n";
      }
    }
  }
  return out;
}

}  // namespace

bool isParetoOptimal(const StudyRow& row, const std::vector<StudyRow>& rows) {
  return std::none_of(rows.begin(), rows.end(), [&](const StudyRow& other) { return dominates(other, row); });
}

std::string studyReport(const std::vector<StudyResult>& results, ReportFormat format) {
  switch (format) {
    case ReportFormat::json:
      return json(results);
    case ReportFormat::csv:
      return csv(results);
    case ReportFormat::markdown:
      break;
  }
  return markdown(results);
}

}  // namespace skydrop::app
