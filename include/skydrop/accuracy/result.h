// What studies have measured, as plain data: written and read by result_file.h, shown by the report, the
// cockpit and whoever chooses settings by it. A value; any thread.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "skydrop/accuracy/study.h"

namespace skydrop::accuracy {

struct MetricColumn {
  std::string name, title, unit;  // as metrics() and the observation have them
  double floor = 0;               // ChosenMetric::floor
};

struct PointResult {
  std::string label, series;
  std::optional<double> step;
  Assignments set;                   // what the study turned, and nothing else
  std::vector<std::string> shipped;  // names of shipped combinations that this point is
  std::size_t reference = 0;         // of CaseResult::references
  std::vector<double> errors;        // one a metric, in its order; empty: not measured yet
  std::vector<double> ms;            // of each repeat, in order
  std::string picture, heat;         // files beside the results, PNG; empty: no picture

  bool isMeasured() const { return !errors.empty() && !ms.empty(); }
  double medianMs() const;  // 0 without repeats
  double leastMs() const, mostMs() const;
};

// A reference, and what doubling it changes.
struct ReferenceResult {
  std::string label;            // the settings that make it
  std::vector<double> changes;  // magnitudes, one a metric; empty: not measured yet
  std::string picture;
};

struct CaseResult {
  std::string study, title, method, name;  // of the study, of the case
  std::size_t index = 0;                   // among all cases of the run, by which a report orders them
  std::vector<MetricColumn> metrics;
  std::string timed, timeUnit, clock, machine;
  std::string order;  // Study::order
  std::vector<PointResult> points;
  std::vector<ReferenceResult> references;
  std::string failure;  // why it ended early; empty: it did not

  std::string id() const { return study + "/" + name; }
};

struct Results {
  std::string program;  // "skydrop 0.3.0"
  bool quick = false;
  std::size_t allCases = 0;  // of the whole run, of which these may be a share
  std::string digest;        // of the studies' texts: results of one digest belong together
  std::vector<CaseResult> cases;

  // Null when there is none; valid until a case is added.
  CaseResult* find(std::string_view id);
  const CaseResult* find(std::string_view id) const;
};

// Points of which no other is at least as good in the magnitude of this metric and in time and better in one
// of them; by growing time. Points that are not measured are left out.
std::vector<std::size_t> paretoFront(const CaseResult& result, std::size_t metric);

// The bound of an error that the reference does not resolve; none where the error stands as it is. It stands
// where doubling the reference changes the metric by less than a tenth of it, or where it is at most the
// metric's floor. Else it is known to be at most its magnitude plus twice the change, which is the error of a
// reference that doubling halves.
std::optional<double> boundOf(const CaseResult& result, std::size_t metric, const PointResult& point);

// A reference that resolves no error of a metric above its floor: it is not justified. `point` has the
// largest.
struct Doubt {
  std::size_t metric = 0, reference = 0, point = 0;
  double change = 0, error = 0;
};
std::vector<Doubt> doubts(const CaseResult& result);
std::string doubtText(const CaseResult& result, const Doubt& doubt);

// The observed order of convergence of each series with at least three errors above the floor: the slope of
// the logarithm of the error over that of the step, by least squares.
struct ObservedOrder {
  std::string series;
  double order = 0;
};
std::vector<ObservedOrder> observedOrders(const CaseResult& result, std::size_t metric);

}  // namespace skydrop::accuracy
