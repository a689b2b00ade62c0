#pragma once

#include "app/studies/study.h"

namespace skydrop::app {

// The clouds: the picture's error against the tier reference, and the frame's time, by tier.
StudyResult cloudStudy(const StudyProgress& progress);

}  // namespace skydrop::app
