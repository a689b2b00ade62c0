#include "accuracy/result_lines.h"

#include <algorithm>

#include "skydrop/accuracy/result_file.h"
#include "skydrop/core/error.h"
#include "skydrop/core/json.h"

namespace skydrop::accuracy {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr double kMostIndex = 1e6, kMostValue = 1e300;

std::string lineOf(const ordered_json& line) {
  return line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

ordered_json begin(const char* kind, const CaseResult& of) {
  return {{"line", kind}, {"study", of.study}, {"case", of.name}};
}

// A line's members, refused by name.
class Line {
 public:
  Line(const json& line, std::string_view file, std::string_view place)
      : line_(line), file_(file), place_(place) {
    if (!line.is_object()) refuse("", "is not an object");
  }

  [[noreturn]] void refuse(const std::string& name, std::string_view reason) const {
    throw core::DataError(file_, place_ + (name.empty() ? "" : ": " + name), reason);
  }
  const json& at(const std::string& name) const {
    const auto found = line_.find(name);
    if (found == line_.end()) refuse(name, "is missing");
    return *found;
  }
  std::string text(const std::string& name) const { return core::jsonText(at(name), file_, at_(name)); }
  double number(const std::string& name) const {
    return core::jsonNumber(at(name), file_, at_(name), -kMostValue, kMostValue);
  }
  std::size_t index(const std::string& name, std::size_t below) const {
    const double value = core::jsonWhole(at(name), file_, at_(name), 0, kMostIndex);
    if (value >= static_cast<double>(below)) refuse(name, "is out of range");
    return static_cast<std::size_t>(value);
  }
  bool flag(const std::string& name) const {
    if (!at(name).is_boolean()) refuse(name, "is not true or false");
    return at(name).get<bool>();
  }
  const json& list(const std::string& name) const {
    if (!at(name).is_array()) refuse(name, "is not a list");
    return at(name);
  }
  std::vector<std::string> texts(const std::string& name) const {
    std::vector<std::string> all;
    for (const json& one : list(name)) all.push_back(core::jsonText(one, file_, at_(name)));
    return all;
  }
  std::vector<double> numbers(const std::string& name, std::size_t count) const {
    std::vector<double> all;
    for (const json& one : list(name))
      all.push_back(core::jsonNumber(one, file_, at_(name), -kMostValue, kMostValue));
    if (all.size() != count) refuse(name, "has not one number a metric");
    return all;
  }

 private:
  std::string at_(const std::string& name) const { return place_ + ": " + name; }

  const json& line_;
  std::string file_, place_;
};

CaseResult& caseOf(const Line& line, Results& results) {
  CaseResult* found = results.find(line.text("study") + "/" + line.text("case"));
  if (!found) line.refuse("case", "was not begun");
  return *found;
}

CaseResult readCase(const Line& line, std::string_view file, std::string_view place) {
  CaseResult of;
  of.study = line.text("study"), of.name = line.text("case");
  of.title = line.text("title"), of.method = line.text("method");
  of.index = line.index("index", static_cast<std::size_t>(kMostIndex));
  of.timed = line.text("timed"), of.timeUnit = line.text("timeUnit");
  of.machine = line.text("machine"), of.order = line.text("order");
  for (const json& one : line.list("metrics")) {
    const Line metric(one, file, std::string(place) + ": metrics");
    of.metrics.push_back(
        {metric.text("name"), metric.text("title"), metric.text("unit"), metric.number("floor")});
  }
  for (const std::string& label : line.texts("references")) of.references.push_back({label, {}, ""});
  for (const json& one : line.list("points")) {
    const Line point(one, file, std::string(place) + ": points");
    PointResult read;
    read.label = point.text("label"), read.series = point.text("series");
    if (!point.at("step").is_null()) read.step = point.number("step");
    read.set = point.texts("set"), read.shipped = point.texts("shipped");
    read.reference = point.index("reference", of.references.size());
    of.points.push_back(read);
  }
  if (of.points.empty() || of.metrics.empty()) line.refuse("", "has no points or no metrics");
  return of;
}

void readHead(const Line& line, Results& results) {
  if (line.at("schema") != kResultSchema) line.refuse("schema", "is not " + std::to_string(kResultSchema));
  results.program = line.text("program");
  results.quick = line.flag("quick");
  results.allCases = line.index("cases", static_cast<std::size_t>(kMostIndex));
  results.digest = line.text("digest");
}

}  // namespace

std::string headLine(const Results& r) {
  return lineOf({{"line", "head"},
                 {"schema", kResultSchema},
                 {"program", r.program},
                 {"quick", r.quick},
                 {"cases", r.allCases},
                 {"digest", r.digest}});
}

std::string caseLine(const CaseResult& of) {
  ordered_json line = begin("case", of);
  line["index"] = of.index;
  line["title"] = of.title, line["method"] = of.method;
  line["timed"] = of.timed, line["timeUnit"] = of.timeUnit;
  line["machine"] = of.machine, line["order"] = of.order;
  line["metrics"] = line["references"] = line["points"] = ordered_json::array();
  for (const MetricColumn& m : of.metrics)
    line["metrics"].push_back({{"name", m.name}, {"title", m.title}, {"unit", m.unit}, {"floor", m.floor}});
  for (const ReferenceResult& reference : of.references) line["references"].push_back(reference.label);
  for (const PointResult& p : of.points) {
    line["points"].push_back({{"label", p.label},
                              {"series", p.series},
                              {"step", p.step ? ordered_json(*p.step) : ordered_json()},
                              {"set", p.set},
                              {"shipped", p.shipped},
                              {"reference", p.reference}});
  }
  return lineOf(line);
}

std::string referenceLine(const CaseResult& of, std::size_t index) {
  ordered_json line = begin("reference", of);
  line["reference"] = index;
  line["changes"] = of.references[index].changes;
  line["units"] = ordered_json::array();
  for (const MetricColumn& metric : of.metrics) line["units"].push_back(metric.unit);
  line["picture"] = of.references[index].picture;
  return lineOf(line);
}

std::string errorLine(const CaseResult& of, std::size_t point) {
  ordered_json line = begin("error", of);
  line["point"] = point;
  line["errors"] = of.points[point].errors;
  line["picture"] = of.points[point].picture;
  line["heat"] = of.points[point].heat;
  return lineOf(line);
}

std::string timeLine(const CaseResult& of, std::size_t point, double ms) {
  ordered_json line = begin("time", of);
  line["point"] = point;
  line["ms"] = ms;
  return lineOf(line);
}

std::string clockLine(const CaseResult& of) {
  ordered_json line = begin("clock", of);
  line["clock"] = of.clock;
  line["machine"] = of.machine;
  return lineOf(line);
}

std::string failureLine(const CaseResult& of) {
  ordered_json line = begin("failure", of);
  line["reason"] = of.failure;
  return lineOf(line);
}

CaseResult& describeCase(const CaseResult& description, Results& results) {
  CaseResult* known = results.find(description.id());
  if (!known) {
    results.cases.push_back(description);
    return results.cases.back();
  }
  CaseResult next = description;
  next.clock = known->clock;
  for (std::size_t i = 0; i < std::min(next.metrics.size(), known->metrics.size()); ++i)
    next.metrics[i].unit = known->metrics[i].unit;
  for (std::size_t i = 0; i < std::min(next.references.size(), known->references.size()); ++i) {
    if (next.references[i].label == known->references[i].label) next.references[i] = known->references[i];
  }
  for (std::size_t i = 0; i < std::min(next.points.size(), known->points.size()); ++i) {
    const PointResult& old = known->points[i];
    if (next.points[i].label != old.label) continue;
    next.points[i].errors = old.errors, next.points[i].ms = old.ms;
    next.points[i].picture = old.picture, next.points[i].heat = old.heat;
  }
  *known = std::move(next);
  return *known;
}

void addLine(const json& parsed, std::string_view file, std::string_view place, Results& results) {
  const Line line(parsed, file, place);
  const std::string kind = line.text("line");
  if (results.digest.empty() != (kind == "head"))
    line.refuse("line", results.digest.empty() ? "is not the head of a results file" : "is a second head");
  if (kind == "head") return readHead(line, results);
  if (kind == "case") {
    describeCase(readCase(line, file, place), results);
    return;
  }
  CaseResult& of = caseOf(line, results);
  if (kind == "reference") {
    ReferenceResult& reference = of.references[line.index("reference", of.references.size())];
    reference.changes = line.numbers("changes", of.metrics.size());
    reference.picture = line.text("picture");
    const std::vector<std::string> units = line.texts("units");
    if (units.size() != of.metrics.size()) line.refuse("units", "has not one a metric");
    for (std::size_t i = 0; i < units.size(); ++i) of.metrics[i].unit = units[i];
  } else if (kind == "error") {
    PointResult& point = of.points[line.index("point", of.points.size())];
    point.errors = line.numbers("errors", of.metrics.size());
    point.picture = line.text("picture"), point.heat = line.text("heat");
  } else if (kind == "time") {
    of.points[line.index("point", of.points.size())].ms.push_back(line.number("ms"));
  } else if (kind == "clock") {
    of.clock = line.text("clock");
    of.machine = line.text("machine");
  } else if (kind == "failure") {
    of.failure = line.text("reason");
  } else {
    line.refuse("line", "unknown kind '" + kind + "'");
  }
}

}  // namespace skydrop::accuracy
