#include "app/studies/budget_calibration.h"

#include <utility>
#include <vector>

#include "app/studies/picture_subject.h"
#include "app/types/version.h"
#include "skydrop/accuracy/metrics.h"
#include "skydrop/core/assets.h"
#include "skydrop/core/error.h"

namespace skydrop::app {
namespace {

class CaseMeasurement {
 public:
  CaseMeasurement(const accuracy::Study& study, const accuracy::StudyCase& where,
                  const Calibration& calibration, std::function<void()> step)
      : study_(study), where_(where), calibration_(calibration), step_(std::move(step)) {
    where_.scene = calibration.scene;
  }

  accuracy::CaseResult measure() {
    accuracy::CaseResult result;
    result.study = study_.name, result.title = study_.title, result.method = study_.method;
    result.name = where_.name;
    result.timed = study_.timed, result.timeUnit = study_.timeUnit;
    const accuracy::Metric& metric = *accuracy::findMetric(study_.metrics.front().name);
    result.metrics = {{study_.metrics.front().name, std::string(metric.title), std::string(metric.unit), 0}};
    result.machine = calibration_.key.machine();
    result.references = {{"reference", {}, ""}};
    for (const accuracy::StudyPoint& point : study_.points) {
      accuracy::PointResult of;
      of.label = point.label, of.set = point.set, of.series = point.series;
      result.points.push_back(std::move(of));
    }
    measureErrors(metric, result);
    measureTimes(result);
    return result;
  }

 private:
  accuracy::Experiment experiment(const accuracy::Assignments& set) const {
    return {where_, accuracy::merged(accuracy::merged(calibration_.set, study_.set), set), study_.timed,
            true};
  }

  accuracy::Observation observed(PictureSubject& subject, const accuracy::Assignments& set) const {
    accuracy::Observation observation = subject.observe(experiment(set));
    if (const std::string bad = accuracy::notFiniteAt(observation); !bad.empty())
      throw core::DataError(study_.name, where_.name, bad);
    return observation;
  }

  void measureErrors(const accuracy::Metric& metric, accuracy::CaseResult& result) {
    PictureSubject subject(calibration_.errorSize);
    const accuracy::Observation reference = observed(subject, study_.reference);
    step_();
    for (accuracy::PointResult& point : result.points) {
      point.errors = {metric.measure(observed(subject, point.set), reference)};
      step_();
    }
  }

  // In turns, so that what drifts hits all alike; the subject draws a frame that is not counted before each.
  void measureTimes(accuracy::CaseResult& result) {
    PictureSubject subject(calibration_.key.size);
    for (int round = 0; round < calibration_.repeats; ++round) {
      for (accuracy::PointResult& point : result.points) {
        const bool isLong = !point.ms.empty() && point.ms.front() > Calibration::kLongMs;
        if (!isLong) point.ms.push_back(subject.timeOnce(experiment(point.set)));
        step_();
      }
    }
    result.clock = subject.clock(experiment(result.points.front().set));
  }

  const accuracy::Study& study_;
  accuracy::StudyCase where_;
  const Calibration& calibration_;
  std::function<void()> step_;
};

}  // namespace

accuracy::Study budgetStudy() {
  accuracy::Study study = accuracy::loadStudy(core::assetPath("budget/study.json").string());
  study.name = "frame-budget";
  return study;
}

accuracy::Results calibrated(const accuracy::Study& study, const Calibration& calibration,
                             const std::function<void(std::size_t done, std::size_t all)>& tell) {
  accuracy::Results results;
  results.program = programName();
  results.quick = true;
  results.allCases = study.cases.size();
  results.digest = "frame-budget";
  const std::size_t parts = 1 + study.points.size() * (1 + static_cast<std::size_t>(calibration.repeats));
  std::size_t done = 0;
  for (const accuracy::StudyCase& where : study.cases) {
    const auto step = [&] {
      ++done;
      if (tell) tell(done, parts * study.cases.size());
    };
    results.cases.push_back(CaseMeasurement(study, where, calibration, step).measure());
    results.cases.back().index = results.cases.size() - 1;
  }
  return results;
}

}  // namespace skydrop::app
