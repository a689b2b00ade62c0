#pragma once

#include "app/studies/study.h"

namespace skydrop::app {

// Every integrator of flight at several step rates on hard case P01's body, against a far finer one.
StudyResult integratorStudy(const StudyProgress& progress);

}  // namespace skydrop::app
