#include "skydrop/accuracy/report.h"

#include "accuracy/report_json.h"
#include "accuracy/report_text.h"
#include "skydrop/core/csv.h"
#include "skydrop/core/file.h"
#include "skydrop/core/joined.h"

namespace skydrop::accuracy {
namespace {

constexpr std::string_view kIntroduction =
    R"(Each study turns one approximation. A row has its error against the reference and its time: the median of repeats that
ran in turns over all rows, with the least and the most. Pareto-optimal rows, of which none is both cheaper and better in
the first error, say so. Doubling the reference changes it by the last row: less than a tenth of every error above it.
Where it is more, the error is not resolved: the table has a bound for it, its magnitude and twice that change. A reference
that resolves no row is not justified, and the table says so. Made by `skydrop accuracy`.)";

// A cell of a Markdown table.
std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.insert(at, "\\");
  return " " + text + " |";
}

std::string timeText(const PointResult& point) {
  if (point.ms.empty()) return "";
  return shownNumber(point.medianMs()) + " (" + shownNumber(point.leastMs()) + " to " +
         shownNumber(point.mostMs()) + ")";
}

void addTable(const CaseResult& of, std::string& out) {
  out += "| |";
  for (const MetricColumn& metric : of.metrics) out += cell(titled(metric));
  out += cell(of.timeUnit) + " Pareto-optimal | |\n|---|";
  for (std::size_t i = 0; i < of.metrics.size() + 3; ++i) out += "---|";
  out += "\n";
  for (std::size_t i = 0; i < of.points.size(); ++i) {
    const PointResult& point = of.points[i];
    out += "|" + cell(point.label);
    for (std::size_t m = 0; m < of.metrics.size(); ++m)
      out += cell(m < point.errors.size() ? shownError(of, m, point) : "");
    out += cell(timeText(point)) + cell(isOnFront(of, 0, i) ? "yes" : "") +
           cell(core::joined(point.shipped)) + "\n";
  }
  for (const ReferenceResult& reference : of.references) {
    if (reference.changes.empty()) continue;
    out += "|" + cell("*doubled reference*");
    for (const double change : reference.changes) out += cell(shownNumber(change));
    out += " | | |\n";
  }
  out += "\n";
  const std::vector<std::string> remarks = remarksOf(of);
  for (const std::string& line : remarks) out += "- " + line + "\n";
  if (!remarks.empty()) out += "\n";
}

}  // namespace

std::string markdownReport(const Results& results) {
  std::string out = "# What accuracy costs\n\n" + std::string(kIntroduction) + "\n\n";
  if (results.quick) out += "A quick run: small pictures, three repeats.\n\n";
  std::string study;
  for (const CaseResult& of : results.cases) {
    if (of.study != study) {
      study = of.study;
      out += "## " + of.title + "\n\n" + of.method + "\n\n";
      out += "Study `" + of.study + "`, timed by " + of.clock + " on " + of.machine + ".\n\n";
    }
    out += "### " + of.title + ": " + of.name + "\n\n";
    addTable(of, out);
  }
  return out;
}

std::string jsonReport(const Results& results) { return reportJson(results, {}).dump(1) + "\n"; }

std::string csvReport(const Results& results) {
  using core::csvField;
  std::string out =
      "study,case,point,set,metric,unit,error,bound,medianMs,leastMs,mostMs,timeUnit,clock,paretoOptimal,"
      "shipped\r\n";
  for (const CaseResult& of : results.cases) {
    for (std::size_t i = 0; i < of.points.size(); ++i) {
      const PointResult& point = of.points[i];
      for (std::size_t m = 0; m < point.errors.size(); ++m) {
        const std::optional<double> bound = boundOf(of, m, point);
        out += csvField(of.study) + "," + csvField(of.name) + "," + csvField(point.label) + "," +
               csvField(core::joined(point.set)) + "," + of.metrics[m].name + "," +
               csvField(of.metrics[m].unit) + "," + exactNumber(point.errors[m]) + "," +
               (bound ? exactNumber(*bound) : "") + "," + exactNumber(point.medianMs()) + "," +
               exactNumber(point.leastMs()) + "," + exactNumber(point.mostMs()) + "," +
               csvField(of.timeUnit) + "," + csvField(of.clock) + "," + (isOnFront(of, m, i) ? "yes" : "no") +
               "," + csvField(core::joined(point.shipped)) + "\r\n";
      }
    }
  }
  return out;
}

std::vector<std::filesystem::path> writeReport(const Results& results, const std::filesystem::path& folder) {
  core::makeFolder(folder);
  std::vector<std::filesystem::path> files;
  const auto write = [&](const char* name, const std::string& text) {
    files.push_back(folder / name);
    core::writeFileAtomically(files.back(), text);
  };
  write("accuracy.csv", csvReport(results));
  write("accuracy.json", jsonReport(results));
  write("accuracy.md", markdownReport(results));
  write("accuracy.html", htmlReport(results, folder));
  return files;
}

}  // namespace skydrop::accuracy
