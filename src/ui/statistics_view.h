// The statistics section of the menu: what each pass of the frame costs.
#pragma once

#include "skydrop/core/frame_statistics.h"

namespace skydrop::ui {

void drawStatistics(const core::FrameStatistics& statistics);

}  // namespace skydrop::ui
