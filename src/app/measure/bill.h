// The bill of a run: who pays for what of a frame (core::FrameStatistics::bill).
#pragma once

#include <string_view>

#include "skydrop/core/frame_statistics.h"

namespace skydrop::app {

// The row of what belongs to no effect: the frame's own start, tone map, the world's clock.
inline constexpr std::string_view kFrameRow = "frame";

// The row of this name, added at the end where there is none. Valid until a row is added.
core::EffectStatistics& billRow(core::FrameStatistics& statistics, std::string_view name);

// What of a frame of 1/60 s the rows account for, ms: passes, updates, and the simulation of two steps.
double paidMs(const core::FrameStatistics& statistics);

}  // namespace skydrop::app
