#include "skydrop/accuracy/runner.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <set>

#include "skydrop/accuracy/flip.h"
#include "skydrop/accuracy/metrics.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/hash.h"
#include "skydrop/core/image.h"

namespace skydrop::accuracy {
namespace {

std::string joined(const Assignments& all) {
  std::string text;
  for (const std::string& one : all) text += (text.empty() ? "" : ", ") + one;
  return text;
}

// The experiments of a case: those of its points, the distinct references and their doublings.
struct Plan {
  std::vector<Experiment> points, references, checks;
  std::vector<std::size_t> referenceOf;  // of each point
};

Experiment experimentOf(const Study& study, const StudyCase& where, const Assignments& set,
                        const RunOptions& options) {
  return {where, merged(merged(study.set, where.set), set), study.timed, options.quick};
}

Plan planOf(const Study& study, const StudyCase& where, const RunOptions& options) {
  Plan plan;
  std::map<Assignments, std::size_t> known;
  for (const StudyPoint& point : study.points) {
    plan.points.push_back(experimentOf(study, where, point.set, options));
    Assignments of = merged(point.set, study.reference);
    const Experiment reference = experimentOf(study, where, of, options);
    Assignments key = reference.set;
    std::ranges::sort(key);
    const auto [entry, isNew] = known.emplace(key, plan.references.size());
    if (isNew) {
      plan.references.push_back(reference);
      plan.checks.push_back(experimentOf(study, where, merged(of, study.check), options));
    }
    plan.referenceOf.push_back(entry->second);
  }
  return plan;
}

Assignments sortedCheck(const Subject& subject, const Experiment& experiment) {
  Assignments all = subject.checked(experiment);
  std::ranges::sort(all);
  return all;
}

// What the point sets that the case and the study do not.
bool setsAll(const Assignments& of, const Assignments& wanted) {
  return std::ranges::all_of(wanted,
                             [&](const std::string& one) { return std::ranges::find(of, one) != of.end(); });
}

Subject& subjectOf(const Study& study, const SubjectSource& subjects) {
  Subject* subject = subjects(study.subject);
  if (!subject) throw core::DataError(study.file, "subject", "there is no subject '" + study.subject + "'");
  return *subject;
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

class CaseRun {
 public:
  CaseRun(const Study& study, const StudyCase& where, Subject& subject, const RunOptions& options,
          ResultWriter& writer, std::size_t index, std::function<void()> step)
      : study_(study),
        subject_(subject),
        options_(options),
        writer_(writer),
        step_(std::move(step)),
        plan_(planOf(study, where, options)),
        result_(writer.begin(described(where, index))) {}

  static std::size_t partsOf(const Study& study, const StudyCase& where, const RunOptions& options) {
    const Plan plan = planOf(study, where, options);
    return 2 * plan.references.size() +
           plan.points.size() * (1 + static_cast<std::size_t>(options.repeats()));
  }

  void run() {
    try {
      measureErrors();
      measureTimes();
    } catch (const core::DataError& error) {
      writer_.failure(result_, error.what());
    } catch (const core::RangeError& error) {
      writer_.failure(result_, error.what());
    }
  }

 private:
  CaseResult described(const StudyCase& where, std::size_t index) const {
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
        const Experiment other = experimentOf(study_, where, merged(point.set, shipped.set), options_);
        if (setsAll(set, subject_.checked(other))) of.shipped.push_back(shipped.name);
      }
      result.points.push_back(of);
    }
    for (const Experiment& reference : plan_.references)
      result.references.push_back({joined(reference.set), {}, ""});
    return result;
  }

  Observation observed(const Experiment& experiment, const std::string& label) {
    Observation observation = subject_.observe(experiment);
    if (const std::string bad = notFiniteAt(observation); !bad.empty())
      throw core::DataError(study_.name, result_.name + ", " + label, bad);
    return observation;
  }

  std::vector<double> errorsOf(const Observation& a, const Observation& reference) {
    std::vector<double> errors;
    for (MetricColumn& column : result_.metrics) {
      const Metric& metric = *findMetric(column.name);
      requireMeasurable(metric, a, reference);
      column.unit = unitOf(metric, a);
      errors.push_back(metric.measure(a, reference));
    }
    return errors;
  }

  std::string keptPicture(const core::Image& image, const std::string& what) {
    const std::string name = fileName(result_.id(), what);
    core::makeFolder(writer_.folder() / "pictures");
    core::writePng(writer_.folder() / name, image);
    return name;
  }

  void measureErrors() {
    for (std::size_t r = 0; r < plan_.references.size(); ++r) measureAgainst(r);
  }

  void measureAgainst(std::size_t r) {
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

  // In turns; the first turn of a case that was not begun is a warm-up that does not count.
  void measureTimes() {
    const auto repeats = static_cast<std::size_t>(options_.repeats());
    const auto isMissing = [&](const PointResult& point) { return point.ms.size() < repeats; };
    if (std::ranges::none_of(result_.points, isMissing)) return;
    for (const Experiment& point : plan_.points) subject_.timeOnce(point);
    writer_.clock(result_, subject_.clock(plan_.points.front()), subject_.machine());
    for (std::size_t round = 0; round < repeats; ++round) {
      for (std::size_t i = 0; i < plan_.points.size(); ++i) {
        if (result_.points[i].ms.size() > round) continue;
        writer_.time(result_, i, subject_.timeOnce(plan_.points[i]));
        step_();
      }
    }
  }

  const Study& study_;
  Subject& subject_;
  const RunOptions& options_;
  ResultWriter& writer_;
  std::function<void()> step_;
  Plan plan_;
  CaseResult& result_;
};

bool isComplete(const CaseResult* result, const RunOptions& options) {
  return result && result->failure.empty() &&
         std::ranges::all_of(result->points, [&](const PointResult& point) {
           return !point.errors.empty() && point.ms.size() >= static_cast<std::size_t>(options.repeats());
         });
}

}  // namespace

bool Part::holds(std::size_t caseIndex) const {
  return caseIndex % static_cast<std::size_t>(count) == static_cast<std::size_t>(index - 1);
}

std::string progressText(const RunProgress& p) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), ": %zu of %zu", p.done, p.all);
  std::string line = p.what + text.data();
  if (p.secondsLeft <= 0) return line;
  const auto seconds = static_cast<long>(std::ceil(p.secondsLeft));
  std::snprintf(text.data(), text.size(), ", %ld:%02ld left", seconds / 60, seconds % 60);
  return line + text.data();
}

void requireRunnable(const std::vector<Study>& studies, const SubjectSource& subjects,
                     const RunOptions& options) {
  std::set<std::string> names;
  for (const Study& study : studies) {
    if (!names.insert(study.name).second)
      throw core::DataError(study.file, "", "another study of this run is called '" + study.name + "' too");
    const Subject& subject = subjectOf(study, subjects);
    for (const StudyCase& where : study.cases) {
      const Plan plan = planOf(study, where, options);
      const auto checked = [&](const Experiment& experiment, const std::string& place) {
        try {
          return sortedCheck(subject, experiment);
        } catch (const core::RangeError& error) {
          throw core::DataError(study.file, place, error.what());
        } catch (const core::UsageError& error) {
          throw core::DataError(study.file, place, error.what());
        }
      };
      for (std::size_t i = 0; i < plan.points.size(); ++i) {
        const Assignments point = checked(plan.points[i], "'" + study.points[i].label + "'");
        if (point == checked(plan.references[plan.referenceOf[i]], "reference"))
          throw core::DataError(study.file, "reference",
                                "is the point '" + study.points[i].label + "' itself");
      }
      for (std::size_t r = 0; r < plan.references.size(); ++r) {
        if (checked(plan.checks[r], "check") == checked(plan.references[r], "reference"))
          throw core::DataError(study.file, "check", "sets what the reference has: nothing is doubled");
      }
      for (const ShippedPoint& shipped : study.shipped)
        checked(experimentOf(study, where, shipped.set, options), "shipped '" + shipped.name + "'");
    }
  }
}

std::string digestOf(const std::vector<Study>& studies, const RunOptions& options) {
  core::StateHasher hash;
  hash.add(std::uint64_t{options.quick});
  const auto add = [&](const std::string& text) {
    hash.add(std::uint64_t{text.size()});
    for (const char c : text) hash.add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
  };
  add(options.effort);
  for (const Study& study : studies) add(study.name), add(study.text);
  std::array<char, 20> text{};
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(hash.value()));
  return text.data();
}

void run(const std::vector<Study>& studies, const SubjectSource& subjects, const RunOptions& options,
         ResultWriter& writer, const std::function<void(const RunProgress&)>& tell) {
  struct Job {
    const Study* study;
    const StudyCase* where;
    std::size_t index, parts;
  };
  std::vector<Job> jobs;
  RunProgress progress;
  std::size_t index = 0;
  for (const Study& study : studies) {
    for (const StudyCase& where : study.cases) {
      const std::size_t at = index++;
      const CaseResult* known = writer.results().find(study.name + "/" + where.name);
      if (!options.part.holds(at) || isComplete(known, options)) continue;
      jobs.push_back({&study, &where, at, CaseRun::partsOf(study, where, options)});
      progress.all += jobs.back().parts;
    }
  }
  const auto begin = std::chrono::steady_clock::now();
  std::size_t before = 0;
  for (const Job& job : jobs) {
    progress.what = job.study->name + ", " + job.where->name;
    progress.done = before;
    const auto step = [&] {
      ++progress.done;
      const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
      progress.secondsLeft = passed.count() / static_cast<double>(progress.done) *
                             static_cast<double>(progress.all - std::min(progress.done, progress.all));
      if (tell) tell(progress);
    };
    if (tell) tell(progress);
    Subject& subject = subjectOf(*job.study, subjects);
    CaseRun(*job.study, *job.where, subject, options, writer, job.index, step).run();
    before += job.parts;
  }
}

}  // namespace skydrop::accuracy
