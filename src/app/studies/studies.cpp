#include "app/studies/cloud_study.h"
#include "app/studies/cost_study.h"
#include "app/studies/integrator_study.h"
#include "app/studies/land_study.h"
#include "app/studies/study.h"

namespace skydrop::app {
namespace {

// Of a study that makes one table and has nothing to choose.
template <StudyResult (*kStudy)(const StudyProgress&)>
std::vector<StudyResult> one(const StudyOptions&, const StudyProgress& progress) {
  return {kStudy(progress)};
}

}  // namespace

const std::vector<Study>& studies() {
  static const std::vector<Study> all = {
      {"integrators", "attitude error of a tumbling body against time, by integrator and step rate",
       one<integratorStudy>},
      {"land", "the picture's error against frame time, by the land's pixel error", one<landStudy>},
      {"clouds", "the picture's error against frame time, by the clouds' tier", one<cloudStudy>},
      {.name = "cost",
       .description = "what each effect of each scene costs, and the sky in its kinds",
       .run = costStudy,
       .takesOptions = true,
       .onlyByName = true,
       .heading = &kCostHeading},
  };
  return all;
}

}  // namespace skydrop::app
