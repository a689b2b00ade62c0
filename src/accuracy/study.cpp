#include "skydrop/accuracy/study.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>

#include "accuracy/study_reader.h"
#include "skydrop/accuracy/metrics.h"
#include "skydrop/core/assets.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/joined.h"
#include "skydrop/core/json.h"
#include "skydrop/core/nearest_names.h"

namespace skydrop::accuracy {
namespace {

using nlohmann::json;

constexpr double kMostSeconds = 3600, kFarthestM = 1e7;

std::string_view pathOf(std::string_view assignment) { return assignment.substr(0, assignment.find('=')); }

StudyFlight readFlight(const StudyReader& reader, const json& of, const std::string& place) {
  reader.requireObject(of, place, {"speedMps", "bankDegrees", "frames"});
  StudyFlight flight;
  const auto take = [&](const char* name, double least, double most, double otherwise) {
    return of.contains(name) ? reader.number(of[name], place + "." + name, least, most) : otherwise;
  };
  flight.speedMps = take("speedMps", 0, 1000, flight.speedMps);
  flight.bankDegrees = take("bankDegrees", -80, 80, flight.bankDegrees);
  const double frames = take("frames", 1, 600, flight.frames);
  if (frames != std::floor(frames)) reader.refuse(place + ".frames", "is not a whole number");
  flight.frames = static_cast<int>(frames);
  return flight;
}

StudyCase readCase(const StudyReader& reader, const json& of, const std::string& place,
                   const std::string& sceneOfAll) {
  reader.requireObject(of, place, {"name", "scene", "pose", "flight", "seconds", "set"});
  StudyCase result;
  result.name = reader.text(of, "name", place);
  if (result.name.find('/') != std::string::npos) reader.refuse(place + ".name", "holds a slash");
  result.scene = reader.textOr(of, "scene", place, sceneOfAll);
  result.set = reader.assignments(of, "set", place);
  if (of.contains("seconds"))
    result.seconds = reader.number(of["seconds"], place + ".seconds", 0, kMostSeconds);
  if (of.contains("pose")) {
    const json& pose = of["pose"];
    if (!pose.is_array() || pose.size() != 6) reader.refuse(place + ".pose", "is not a list of six numbers");
    result.pose.emplace();
    for (std::size_t i = 0; i < 6; ++i)
      (*result.pose)[i] = reader.number(pose[i], place + ".pose", -kFarthestM, kFarthestM);
  }
  if (of.contains("flight")) {
    if (!result.pose) reader.refuse(place + ".flight", "needs a pose to begin at");
    result.flight = readFlight(reader, of["flight"], place + ".flight");
  }
  return result;
}

struct Axis {
  std::string path;
  std::vector<std::string> values;
  std::vector<std::optional<double>> numbers;
  std::string unit;  // for labels
};

Axis readAxis(const StudyReader& reader, const json& of, const std::string& place) {
  reader.requireObject(of, place, {"path", "values", "unit"});
  Axis axis;
  axis.path = reader.text(of, "path", place);
  axis.unit = reader.textOr(of, "unit", place, "");
  for (const json& value : reader.list(of, "values", place, kMostPoints)) {
    axis.values.push_back(reader.valueText(value, place + ".values"));
    axis.numbers.push_back(value.is_number() ? std::optional(value.get<double>()) : std::nullopt);
  }
  return axis;
}

// The product of the axes; the first changes slowest.
std::vector<StudyPoint> productOf(const std::vector<Axis>& axes, const std::string& order) {
  std::vector<StudyPoint> points = {{}};
  for (const Axis& axis : axes) {
    std::vector<StudyPoint> next;
    for (const StudyPoint& point : points) {
      for (std::size_t i = 0; i < axis.values.size() && next.size() <= kMostPoints; ++i) {
        StudyPoint more = point;
        const std::string label = axis.values[i] + (axis.unit.empty() ? "" : " " + axis.unit);
        const auto add = [&](std::string& to) { to += (to.empty() ? "" : ", ") + label; };
        add(more.label);
        if (axis.path == order) {
          more.step = axis.numbers[i];
        } else {
          add(more.series);
        }
        more.set.push_back(axis.path + "=" + axis.values[i]);
        next.push_back(more);
      }
    }
    points = std::move(next);
  }
  return points;
}

std::vector<StudyPoint> readPoints(const StudyReader& reader, const json& of, const std::string& order) {
  if (of.contains("axes") == of.contains("points")) reader.refuse("", "needs either axes or points");
  std::vector<StudyPoint> points;
  if (of.contains("axes")) {
    std::vector<Axis> axes;
    for (const json& axis : reader.list(of, "axes", "", 3))
      axes.push_back(readAxis(reader, axis, "axes." + std::to_string(axes.size())));
    const bool hasOrder = std::ranges::any_of(axes, [&](const Axis& axis) { return axis.path == order; });
    if (!order.empty() && !hasOrder) reader.refuse("order", "is the path of none of the axes");
    points = productOf(axes, order);
  } else {
    if (!order.empty()) reader.refuse("order", "belongs to axes");
    for (const json& point : reader.list(of, "points", "", kMostPoints)) {
      const std::string place = "points." + std::to_string(points.size());
      reader.requireObject(point, place, {"name", "set"});
      points.push_back({reader.text(point, "name", place), reader.assignments(point, "set", place), "", {}});
    }
  }
  if (points.size() > kMostPoints)
    reader.refuse("axes", "make more than " + std::to_string(kMostPoints) + " points");
  return points;
}

ChosenMetric readMetric(const StudyReader& reader, const json& of, const std::string& place) {
  ChosenMetric metric;
  if (of.is_string()) {
    metric.name = of.get<std::string>();
  } else {
    reader.requireObject(of, place, {"name", "floor"});
    metric.name = reader.text(of, "name", place);
    if (of.contains("floor")) metric.floor = reader.number(of["floor"], place + ".floor", 0, 1e30);
  }
  if (!findMetric(metric.name)) {
    std::vector<std::string_view> names;
    for (const Metric& known : metrics()) names.push_back(known.name);
    reader.refuse(place, "unknown metric '" + metric.name + "'" + core::nearestText(metric.name, names));
  }
  return metric;
}

void requireTimed(const StudyReader& reader, const std::string& timed) {
  const bool isPass = timed.starts_with("pass ") && timed.size() > 5;
  if (timed != "frame" && timed != "cpu" && !isPass)
    reader.refuse("timed", "'" + timed + "' is not one of frame, cpu and pass NAME");
}

// Of an axis of rates, whose reference is larger than all values, a step is the inverse.
void takeRatesAsSteps(Study& study) {
  for (const std::string& one : study.reference) {
    if (study.order.empty() || !one.starts_with(study.order + "=")) continue;
    const double reference = std::strtod(one.c_str() + study.order.size() + 1, nullptr);
    const auto isRate = [&](const StudyPoint& point) { return point.step && *point.step < reference; };
    if (!std::ranges::all_of(study.points, isRate)) return;
    for (StudyPoint& point : study.points) point.step = 1 / *point.step;
  }
}

template <class T, class Name>
void requireUnique(const StudyReader& reader, const std::vector<T>& all, const std::string& place,
                   Name name) {
  std::set<std::string> seen;
  for (const T& one : all) {
    if (!seen.insert(one.*name).second) reader.refuse(place, "'" + one.*name + "' is there twice");
  }
}

}  // namespace

Study parseStudy(std::string_view text, std::string_view file) {
  const StudyReader reader{std::string(file)};
  const json of = core::parseJson(text, file, {.bytes = kMostStudyBytes});
  reader.requireObject(of, "",
                       {"schema", "title", "method", "subject", "scene", "set", "cases", "axes", "points",
                        "reference", "check", "metrics", "timed", "timeUnit", "order", "shipped"});
  if (of.value("schema", json()) != kStudySchema)
    reader.refuse("schema", "is not " + std::to_string(kStudySchema));
  Study study;
  study.file = file;
  study.name = std::filesystem::path(study.file).stem().string();
  study.text = text;
  study.title = reader.text(of, "title", "");
  study.method = reader.text(of, "method", "");
  study.subject = reader.text(of, "subject", "");
  study.set = reader.assignments(of, "set", "");
  const std::string scene = reader.textOr(of, "scene", "", "");
  for (const json& one : reader.list(of, "cases", "", kMostCases))
    study.cases.push_back(readCase(reader, one, "cases." + std::to_string(study.cases.size()), scene));
  study.order = reader.textOr(of, "order", "", "");
  study.points = readPoints(reader, of, study.order);
  study.reference = reader.assignments(of, "reference", "");
  takeRatesAsSteps(study);
  if (study.reference.empty()) reader.refuse("reference", "sets nothing");
  study.check = reader.assignments(of, "check", "");
  if (study.check.empty()) reader.refuse("check", "sets nothing: the reference has to be doubled");
  for (const json& metric : reader.list(of, "metrics", "", metrics().size()))
    study.metrics.push_back(readMetric(reader, metric, "metrics." + std::to_string(study.metrics.size())));
  study.timed = reader.text(of, "timed", "");
  requireTimed(reader, study.timed);
  study.timeUnit = reader.textOr(of, "timeUnit", "", study.timed == "cpu" ? "ms of CPU time" : "ms a frame");
  if (of.contains("shipped")) {
    for (const json& one : reader.list(of, "shipped", "", kMostPoints)) {
      const std::string place = "shipped." + std::to_string(study.shipped.size());
      reader.requireObject(one, place, {"name", "set"});
      study.shipped.push_back({reader.text(one, "name", place), reader.assignments(one, "set", place)});
    }
  }
  requireUnique(reader, study.cases, "cases", &StudyCase::name);
  requireUnique(reader, study.points, "points", &StudyPoint::label);
  requireUnique(reader, study.metrics, "metrics", &ChosenMetric::name);
  return study;
}

Study loadStudy(const std::string& nameOrFile) {
  const bool isFile = nameOrFile.find('/') != std::string::npos || nameOrFile.ends_with(".json");
  if (isFile) return parseStudy(core::readTextFile(nameOrFile, kMostStudyBytes), nameOrFile);
  const std::vector<std::string> known = listStudies();
  if (std::ranges::find(known, nameOrFile) == known.end()) {
    throw core::UsageError("accuracy: there is no study '" + nameOrFile +
                           "'; there are: " + core::joined(known));
  }
  const std::filesystem::path file = core::assetPath("studies/" + nameOrFile + ".json");
  return parseStudy(core::readTextFile(file, kMostStudyBytes), file.string());
}

std::vector<std::string> listStudies() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(core::assetPath("studies"))) {
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  return names;
}

Assignments merged(const Assignments& below, const Assignments& above) {
  Assignments all = below;
  all.insert(all.end(), above.begin(), above.end());
  Assignments kept;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto isReplaced = [&](const std::string& later) { return pathOf(later) == pathOf(all[i]); };
    if (std::none_of(all.begin() + static_cast<std::ptrdiff_t>(i) + 1, all.end(), isReplaced))
      kept.push_back(all[i]);
  }
  return kept;
}

}  // namespace skydrop::accuracy
