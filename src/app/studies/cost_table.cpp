#include "app/studies/cost_table.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "skydrop/core/csv.h"

namespace skydrop::app {
namespace {

constexpr int kSchema = 1;
constexpr int kShownDigits = 3, kAllDigits = 17;

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

void writeMarkdown(std::ostream& out, const CostTable& table) {
  out << "## " << table.title << "\n\n" << table.method << "\n\n";
  out << "Timed by " << table.clock << " on " << table.machine << ".\n\n";
  out << "| |";
  for (const CostColumn& column : table.columns)
    out << " " << column.name << (column.unit.empty() ? "" : ", ") << column.unit << " |";
  out << " |\n|---|";
  for (std::size_t i = 0; i < table.columns.size(); ++i) out << "---|";
  out << "---|\n";
  for (const CostRow& row : table.rows) {
    out << "| " << row.label << " |";
    for (const double value : row.values) out << " " << shownNumber(value) << " |";
    out << " " << row.note << " |\n";
  }
  out << "\n";
}

std::string markdown(const std::vector<CostTable>& tables, const ReportHeading& heading) {
  std::ostringstream out;
  out << "# " << heading.title << "\n\n" << heading.introduction << "\n\n";
  for (const CostTable& table : tables) writeMarkdown(out, table);
  return out.str();
}

std::string json(const std::vector<CostTable>& tables) {
  nlohmann::ordered_json studies = nlohmann::ordered_json::array();
  for (const CostTable& table : tables) {
    nlohmann::ordered_json metrics = nlohmann::ordered_json::array(), rows = nlohmann::ordered_json::array();
    for (const CostColumn& column : table.columns)
      metrics.push_back({{"name", column.name}, {"unit", column.unit}});
    for (const CostRow& row : table.rows)
      rows.push_back({{"label", row.label}, {"values", row.values}, {"note", row.note}});
    studies.push_back({{"title", table.title},
                       {"method", table.method},
                       {"machine", table.machine},
                       {"metrics", metrics},
                       {"clock", table.clock},
                       {"rows", rows}});
  }
  return nlohmann::ordered_json{{"schema", kSchema}, {"studies", studies}}.dump(2) + "\n";
}

// Costs, their unit and fronts are columns of the form that are always empty here.
std::string csv(const std::vector<CostTable>& tables) {
  using core::csvField;
  std::string out = "study,label,metric,unit,error,cost,costUnit,clock,paretoOptimal,note\r\n";
  for (const CostTable& table : tables) {
    for (const CostRow& row : table.rows) {
      for (std::size_t i = 0; i < table.columns.size(); ++i) {
        out += csvField(table.title) + "," + csvField(row.label) + "," + csvField(table.columns[i].name) +
               "," + csvField(table.columns[i].unit) + "," + inText(row.values[i], kAllDigits) + ",,," +
               csvField(table.clock) + ",," + csvField(row.note) + "\r\n";
      }
    }
  }
  return out;
}

}  // namespace

std::string reportOf(const std::vector<CostTable>& tables, ReportFormat format,
                     const ReportHeading& heading) {
  switch (format) {
    case ReportFormat::json:
      return json(tables);
    case ReportFormat::csv:
      return csv(tables);
    case ReportFormat::markdown:
      break;
  }
  return markdown(tables, heading);
}

}  // namespace skydrop::app
