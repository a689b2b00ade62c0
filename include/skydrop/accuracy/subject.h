// What studies measure: something with settings that gives an observation and takes time. The runner knows
// nothing else of it. App has the subjects that draw (src/app/studies).
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "skydrop/accuracy/observation.h"
#include "skydrop/accuracy/study.h"

namespace skydrop::accuracy {

// One point of one case: settings complete, those of study, case and point merged.
struct Experiment {
  StudyCase where;
  Assignments set;
  std::string timed;   // Study::timed
  bool quick = false;  // small pictures, short runs
};

// One thread: the one that made it.
class Subject {
 public:
  virtual ~Subject() = default;

  // The assignments as they will be set, values in one spelling, so that equal settings compare equal.
  // Nothing is measured or made. Throws core::RangeError for a path, value, scene or clock that there is not.
  virtual Assignments checked(const Experiment& experiment) const = 0;

  // The same bits whenever it is asked for the same, in any order. Throws core::DataError,
  // core::GraphicsUnavailable.
  virtual Observation observe(const Experiment& experiment) = 0;

  // Does it once more and returns the milliseconds of what Experiment::timed names. What is done only once
  // (shaders, caches) is done before the clock starts.
  virtual double timeOnce(const Experiment& experiment) = 0;

  // After the first timeOnce(): "wall clock between glFinish calls".
  virtual std::string clock(const Experiment& experiment) const = 0;
  virtual std::string machine() const = 0;
};

// A subject by Study::subject, made when it is first asked for and kept by whom it is asked; null: there is
// none of this name.
using SubjectSource = std::function<Subject*(std::string_view name)>;

}  // namespace skydrop::accuracy
