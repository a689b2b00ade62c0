#include "skydrop/accuracy/runner.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <set>

#include "accuracy/case_run.h"
#include "accuracy/plan.h"
#include "skydrop/core/error.h"
#include "skydrop/core/hash.h"

namespace skydrop::accuracy {
namespace {

Assignments sortedAssignments(const Subject& subject, const Experiment& experiment) {
  Assignments all = subject.checked(experiment);
  std::ranges::sort(all);
  return all;
}

Subject& subjectOf(const Study& study, const SubjectSource& subjects) {
  Subject* subject = subjects(study.subject);
  if (!subject) throw core::DataError(study.file, "subject", "there is no subject '" + study.subject + "'");
  return *subject;
}

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
      const Plan plan = planOf(study, where, options.quick);
      const auto checked = [&](const Experiment& experiment, const std::string& place) {
        try {
          return sortedAssignments(subject, experiment);
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
        checked(experimentOf(study, where, shipped.set, options.quick), "shipped '" + shipped.name + "'");
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
