// What the effects of a scene cost, as a table, and its report.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/types/report_format.h"

namespace skydrop::app {

struct CostColumn {
  std::string name;  // "frame without it"
  std::string unit;  // "ms"; empty: a number
};

struct CostRow {
  std::string label;           // "clouds"
  std::vector<double> values;  // one a column, in its unit and order; NaN: there is none
  std::string note;            // "off", or what is special; may be empty
};

struct CostTable {
  std::string title, method;        // what is measured, and how
  std::vector<CostColumn> columns;  // at least one
  std::string clock;                // what timed it
  std::string machine;              // on what
  std::vector<CostRow> rows;
};

// How a report begins.
struct ReportHeading {
  std::string_view title;
  std::string_view introduction;  // Markdown
};

std::string reportOf(const std::vector<CostTable>& tables, ReportFormat format, const ReportHeading& heading);

}  // namespace skydrop::app
