// An accuracy study: one approximation, its knob turned through its range, and for each place of the knob the
// measured error against a converged reference and the measured cost. `skydrop accuracy` runs them.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace skydrop::app {

struct StudyRow {
  std::string knob;   // "rk4 at 120 Hz"
  double error = 0;   // in the study's error unit
  double cost = 0;    // in the study's cost unit
  std::string note;   // "default", or what is special; may be empty
};

struct StudyResult {
  std::string title, method;           // what is measured, against which reference
  std::string errorName, costName;     // with units: "attitude error after 10 s, degrees"
  std::string clock, machine;          // what timed it, and on what
  std::vector<StudyRow> rows;
};

// Told before each row: how many there are of how many, the reference included.
using StudyProgress = std::function<void(std::size_t done, std::size_t all)>;

struct Study {
  std::string_view name;         // "integrators"
  std::string_view description;  // one sentence
  std::function<StudyResult(const StudyProgress&)> run;
};

// All there are, in the order of the report.
const std::vector<Study>& studies();

// Markdown: a section and a table a study, rows Pareto-optimal (no other row is both cheaper and better) marked.
std::string studyReport(const std::vector<StudyResult>& results);

}  // namespace skydrop::app
