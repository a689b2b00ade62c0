#pragma once

#include "app/studies/study.h"

namespace skydrop::app {

// The land's detail: the picture's error against a far finer mesh, and the frame's time, by
// streaming.pixelError.
StudyResult landStudy(const StudyProgress& progress);

}  // namespace skydrop::app
