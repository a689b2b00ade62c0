#include "accuracy/plan.h"

#include <algorithm>
#include <map>

namespace skydrop::accuracy {

Experiment experimentOf(const Study& study, const StudyCase& where, const Assignments& set, bool quick) {
  return {where, merged(merged(study.set, where.set), set), study.timed, quick};
}

Plan planOf(const Study& study, const StudyCase& where, bool quick) {
  Plan plan;
  std::map<Assignments, std::size_t> known;
  for (const StudyPoint& point : study.points) {
    plan.points.push_back(experimentOf(study, where, point.set, quick));
    Assignments of = merged(point.set, study.reference);
    const Experiment reference = experimentOf(study, where, of, quick);
    Assignments key = reference.set;
    std::ranges::sort(key);
    const auto [entry, isNew] = known.emplace(key, plan.references.size());
    if (isNew) {
      plan.references.push_back(reference);
      plan.checks.push_back(experimentOf(study, where, merged(of, study.check), quick));
    }
    plan.referenceOf.push_back(entry->second);
  }
  return plan;
}

}  // namespace skydrop::accuracy
