#include "app/studies/cloud_study.h"
#include "app/studies/integrator_study.h"
#include "app/studies/land_study.h"
#include "app/studies/study.h"

namespace skydrop::app {

const std::vector<Study>& studies() {
  static const std::vector<Study> all = {
      {"integrators", "attitude error of a tumbling body against time, by integrator and step rate",
       integratorStudy},
      {"land", "the picture's error against frame time, by the land's pixel error", landStudy},
      {"clouds", "the picture's error against frame time, by the clouds' tier", cloudStudy},
  };
  return all;
}

}  // namespace skydrop::app
