// One case of a study, measured: references and their doubling, errors, and repeats in turns over its points.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "accuracy/plan.h"
#include "skydrop/accuracy/runner.h"

namespace skydrop::accuracy {

class CaseRun {
 public:
  // Begins the case in the writer's results, as the `index`th of the run. `step` is called after each part of
  // the work. All outlive it.
  CaseRun(const Study& study, const StudyCase& where, Subject& subject, const RunOptions& options,
          ResultWriter& writer, std::size_t index, std::function<void()> step);

  // How many parts there are.
  static std::size_t partsOf(const Study& study, const StudyCase& where, const RunOptions& options);

  // Measures what is missing. What fails (core::DataError, core::RangeError, a value that is not finite) ends
  // the case with its reason.
  void run();

 private:
  CaseResult described(const StudyCase& where, std::size_t index) const;
  Observation observed(const Experiment& experiment, const std::string& label);
  std::vector<double> errorsOf(const Observation& a, const Observation& reference);
  std::string keptPicture(const core::Image& image, const std::string& what);
  void measureErrors();
  void measureAgainst(std::size_t reference);
  // In turns; the first turn of a case that was not begun is a warm-up that does not count.
  void measureTimes();

  const Study& study_;
  Subject& subject_;
  const RunOptions& options_;
  ResultWriter& writer_;
  std::function<void()> step_;
  Plan plan_;
  CaseResult& result_;
};

}  // namespace skydrop::accuracy
