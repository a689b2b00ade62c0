#include <algorithm>
#include <sstream>

#include "app/studies/study.h"

namespace skydrop::app {
namespace {

// Whether some other row is at least as good in both and better in one.
bool isDominated(const StudyRow& row, const std::vector<StudyRow>& rows) {
  return std::any_of(rows.begin(), rows.end(), [&](const StudyRow& other) {
    return other.error <= row.error && other.cost <= row.cost && (other.error < row.error || other.cost < row.cost);
  });
}

void writeNumber(std::ostream& out, double value) {
  out.precision(3);
  out << value;
}

void writeSection(std::ostream& out, const StudyResult& result) {
  out << "## " << result.title << "\n\n" << result.method << "\n\n";
  out << "Timed by " << result.clock << " on " << result.machine << ".\n\n";
  out << "| | " << result.errorName << " | " << result.costName << " | Pareto-optimal | |\n|---|---|---|---|---|\n";
  for (const StudyRow& row : result.rows) {
    out << "| " << row.knob << " | ";
    writeNumber(out, row.error);
    out << " | ";
    writeNumber(out, row.cost);
    out << " | " << (isDominated(row, result.rows) ? "" : "yes") << " | " << row.note << " |\n";
  }
  out << "\n";
}

}  // namespace

std::string studyReport(const std::vector<StudyResult>& results) {
  std::ostringstream out;
  out << "# What accuracy costs\n\n"
         "Each table turns one knob: its error against a converged reference, and its cost. A row is Pareto-optimal\n"
         "when no other row is both cheaper and more accurate. Made by `skydrop accuracy`.\n\n";
  for (const StudyResult& result : results) writeSection(out, result);
  return out.str();
}

}  // namespace skydrop::app
