#include "accuracy/case_run.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "accuracy/report_text.h"
#include "skydrop/accuracy/flip.h"
#include "skydrop/accuracy/metrics.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/image.h"
#include "skydrop/core/joined.h"

namespace skydrop::accuracy {
namespace {

// Whether all that is wanted is among what is set.
bool setsAll(const Assignments& of, const Assignments& wanted) {
  return std::ranges::all_of(wanted,
                             [&](const std::string& one) { return std::ranges::find(of, one) != of.end(); });
}

std::string fileName(const std::string& id, const std::string& what) {
  std::string name = id + "-" + what + ".png";
  for (char& c : name) {
    const bool isPlain =
        (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '.' || c == '-';
    if (!isPlain) c = '-';
  }
  return "pictures/" + name;
}

}  // namespace

CaseRun::CaseRun(const Study& study, const StudyCase& where, Subject& subject, const RunOptions& options,
                 ResultWriter& writer, std::size_t index, std::function<void()> step)
    : study_(study),
      subject_(subject),
      options_(options),
      writer_(writer),
      step_(std::move(step)),
      plan_(planOf(study, where, options.quick)),
      result_(writer.begin(described(where, index))) {}

std::size_t CaseRun::partsOf(const Study& study, const StudyCase& where, const RunOptions& options) {
  const Plan plan = planOf(study, where, options.quick);
  return 2 * plan.references.size() + plan.points.size() * (1 + static_cast<std::size_t>(options.repeats()));
}

void CaseRun::run() {
  try {
    measureErrors();
    measureTimes();
  } catch (const core::DataError& error) {
    writer_.failure(result_, error.what());
  } catch (const core::RangeError& error) {
    writer_.failure(result_, error.what());
  }
}

CaseResult CaseRun::described(const StudyCase& where, std::size_t index) const {
  CaseResult result;
  result.study = study_.name, result.title = study_.title, result.method = study_.method;
  result.name = where.name;
  result.index = index;
  for (const ChosenMetric& chosen : study_.metrics) {
    const Metric& metric = *findMetric(chosen.name);
    result.metrics.push_back(
        {chosen.name, std::string(metric.title), std::string(metric.unit), chosen.floor});
  }
  result.timed = study_.timed, result.timeUnit = study_.timeUnit, result.order = study_.order;
  result.machine = subject_.machine();
  for (std::size_t i = 0; i < study_.points.size(); ++i) {
    const StudyPoint& point = study_.points[i];
    PointResult of;
    of.label = point.label, of.series = point.series, of.step = point.step, of.set = point.set;
    of.reference = plan_.referenceOf[i];
    const Assignments set = subject_.checked(plan_.points[i]);
    for (const ShippedPoint& shipped : study_.shipped) {
      const Experiment other = experimentOf(study_, where, merged(point.set, shipped.set), options_.quick);
      if (setsAll(set, subject_.checked(other))) of.shipped.push_back(shipped.name);
    }
    result.points.push_back(of);
  }
  for (const Experiment& reference : plan_.references)
    result.references.push_back({core::joined(reference.set), {}, ""});
  return result;
}

Observation CaseRun::observed(const Experiment& experiment, const std::string& label) {
  Observation observation = subject_.observe(experiment);
  if (const std::string bad = notFiniteAt(observation); !bad.empty())
    throw core::DataError(study_.name, result_.name + ", " + label, bad);
  return observation;
}

std::vector<double> CaseRun::errorsOf(const Observation& a, const Observation& reference) {
  std::vector<double> errors;
  for (MetricColumn& column : result_.metrics) {
    const Metric& metric = *findMetric(column.name);
    requireMeasurable(metric, a, reference);
    column.unit = unitOf(metric, a);
    errors.push_back(metric.measure(a, reference));
  }
  return errors;
}

std::string CaseRun::keptPicture(const core::Image& image, const std::string& what) {
  const std::string name = fileName(result_.id(), what);
  core::makeFolder(writer_.folder() / "pictures");
  core::writePng(writer_.folder() / name, image);
  return name;
}

void CaseRun::measureErrors() {
  for (std::size_t r = 0; r < plan_.references.size(); ++r) measureAgainst(r);
}

void CaseRun::measureAgainst(std::size_t r) {
  const std::string number = "reference" + std::to_string(r);
  std::optional<Observation> reference;
  const auto needed = [&]() -> const Observation& {
    if (!reference) reference = observed(plan_.references[r], "reference");
    return *reference;
  };
  if (result_.references[r].changes.empty()) {
    needed();
    step_();
    const Observation doubled = observed(plan_.checks[r], "doubled reference");
    std::vector<double> changes = errorsOf(doubled, *reference);
    for (double& change : changes) change = std::abs(change);
    std::string picture = reference->isPicture() ? keptPicture(reference->display, number) : "";
    writer_.reference(result_, r, std::move(changes), std::move(picture));
    step_();
  }
  for (std::size_t i = 0; i < plan_.points.size(); ++i) {
    if (plan_.referenceOf[i] != r || !result_.points[i].errors.empty()) continue;
    const Observation observation = observed(plan_.points[i], result_.points[i].label);
    std::vector<double> errors = errorsOf(observation, needed());
    std::string picture, heat;
    if (observation.isPicture()) {
      picture = keptPicture(observation.display, std::to_string(i));
      const auto map = flipMap({observation.width, observation.height, observation.seen},
                               {reference->width, reference->height, reference->seen});
      heat = keptPicture(heatMap(map, observation.width, observation.height), std::to_string(i) + "-heat");
    }
    writer_.error(result_, i, std::move(errors), std::move(picture), std::move(heat));
    step_();
  }
}

void CaseRun::measureTimes() {
  const auto repeats = static_cast<std::size_t>(options_.repeats());
  const auto isMissing = [&](const PointResult& point) { return point.ms.size() < repeats; };
  if (std::ranges::none_of(result_.points, isMissing)) return;
  double longest = 0;
  for (const Experiment& point : plan_.points) longest = std::max(longest, subject_.timeOnce(point));
  if (longest == 0)
    throw core::DataError(study_.name, result_.name + ", timed",
                          "'" + study_.timed + "' takes no time at any point: no frame has such a pass");
  writer_.clock(result_, subject_.clock(plan_.points.front()), subject_.machine());
  for (std::size_t round = 0; round < repeats; ++round) {
    for (std::size_t i = 0; i < plan_.points.size(); ++i) {
      if (result_.points[i].ms.size() > round) continue;
      writer_.time(result_, i, subject_.timeOnce(plan_.points[i]));
      step_();
    }
  }
}

}  // namespace skydrop::accuracy
