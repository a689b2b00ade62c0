// An accuracy study: one approximation, its parameter turned through its range, and for each value of it the
// measured error against a converged reference and the measured cost. Or what the effects of a scene cost,
// where there is no error to set against it. `skydrop accuracy` runs them.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "app/types/report_format.h"

namespace skydrop::app {

// What is measured at each value of the parameter: an error against the reference, less is better; in a table
// without a trade-off anything that the name says.
struct StudyMetric {
  std::string name;  // "attitude error after 10 s"
  std::string unit;  // "degrees"; empty: a number
};

struct StudyCost {
  std::string unit;   // of time, and for what: "ms a frame"
  std::string clock;  // what timed it: "wall clock, the fastest of 20 runs"
};

// One value of the parameter.
struct StudyRow {
  std::string label;           // "rk4 at 120 Hz"
  std::vector<double> errors;  // one a metric of the study, in its unit and order; NaN: there is none
  double cost = 0;             // in the unit of the study's cost, of a trade-off
  std::string note;            // "default", or what is special; may be empty
};

struct StudyResult {
  std::string title, method;         // what is measured, against which reference
  std::vector<StudyMetric> metrics;  // at least one
  StudyCost cost;
  std::string machine;  // on what it was timed
  std::vector<StudyRow> rows;
  // Errors against cost, Pareto-optimal rows marked. Otherwise the metrics are all there is: cost is left out
  // but for its clock.
  bool isTradeOff = true;
};

// Whether no other row is at least as good in every metric and in cost, and better in one of them.
bool isParetoOptimal(const StudyRow& row, const std::vector<StudyRow>& rows);

// Told before each row: how many there are of how many, the reference included.
using StudyProgress = std::function<void(std::size_t done, std::size_t all)>;

struct StudyOptions {
  std::vector<std::string> scenes = {};  // to measure; none: all of assets/scenes
  bool quick = false;                    // fewer repetitions
};

// How a report begins.
struct ReportHeading {
  std::string_view title;
  std::string_view introduction;  // Markdown
};

std::string studyReport(const std::vector<StudyResult>& results, ReportFormat format,
                        const ReportHeading& heading);

}  // namespace skydrop::app
