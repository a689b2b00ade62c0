// Runs studies: warm-up, references and their doubling, errors, and repeats in turns over all points of a
// case, so that what drifts hits all alike. Knows no study and no subject. One thread.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "skydrop/accuracy/result_file.h"
#include "skydrop/accuracy/study.h"
#include "skydrop/accuracy/subject.h"

namespace skydrop::accuracy {

// A share of the cases of a run: every `count`th, beginning with the `index`th, 1 .. count.
struct Part {
  int index = 1, count = 1;
  bool holds(std::size_t caseIndex) const;
};

struct RunOptions {
  bool quick = false;
  Part part = {};
  std::string effort = {};  // what else results depend on: the size of pictures
  int repeats() const { return quick ? 3 : 5; }
};

struct RunProgress {
  std::string what;               // "clouds, from below: 12 of 40"
  std::size_t done = 0, all = 0;  // parts of the work
  double secondsLeft = 0;         // by the speed so far; 0 while there is none
};
std::string progressText(const RunProgress& progress);

// Judges every study before anything is measured: paths, values, a reference that is one of the values.
// Throws core::DataError that names the study's file and the place.
void requireRunnable(const std::vector<Study>& studies, const SubjectSource& subjects,
                     const RunOptions& options);

// What belongs together in shares and in a run that goes on: the studies' texts and the effort.
std::string digestOf(const std::vector<Study>& studies, const RunOptions& options);

// Measures what of the studies' cases is in the part and not in the writer's results yet. A case that fails
// (core::DataError, a value that is not finite) is noted with its reason, and the next goes on.
void run(const std::vector<Study>& studies, const SubjectSource& subjects, const RunOptions& options,
         ResultWriter& writer, const std::function<void(const RunProgress&)>& tell = {});

}  // namespace skydrop::accuracy
