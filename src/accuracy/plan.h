// The experiments of a case: those of its points, the distinct references and their doublings.
#pragma once

#include <cstddef>
#include <vector>

#include "skydrop/accuracy/study.h"
#include "skydrop/accuracy/subject.h"

namespace skydrop::accuracy {

struct Plan {
  std::vector<Experiment> points, references, checks;
  std::vector<std::size_t> referenceOf;  // of each point
};
Plan planOf(const Study& study, const StudyCase& where, bool quick);

// A point of the case that sets this beside what study and case set.
Experiment experimentOf(const Study& study, const StudyCase& where, const Assignments& set, bool quick);

}  // namespace skydrop::accuracy
