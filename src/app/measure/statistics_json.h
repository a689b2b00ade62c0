// --stats: what a run measured, as JSON.
#pragma once

#include <string>

#include "skydrop/core/frame_statistics.h"
#include "skydrop/core/output_file.h"

namespace skydrop::app {

inline constexpr int kStatisticsSchema = 1;

// Members: schema, frame.ms {median, p99, max}, passes.<name> {ms, draws, dispatches, skipped}, gl, terrain,
// threads, effects, game, window, guards, stateHash (sixteen hexadecimal digits), other {name: ms}.
std::string statisticsJson(const core::FrameStatistics& statistics);

// Throws core::DataError when the file cannot be written.
void writeStatistics(core::OutputFile& file, const core::FrameStatistics& statistics);

}  // namespace skydrop::app
