// --stats: what a run measured, as JSON.
#pragma once

#include <string>

#include "skydrop/core/frame_statistics.h"
#include "skydrop/core/output_file.h"

namespace skydrop::app {

inline constexpr int kStatisticsSchema = 1;

// Members: schema, frame.ms {median, p99, max}, passes.<name> {ms, draws, dispatches, skipped}, gl, terrain,
// threads, effects, bill.<effect> {on, ms, simulationMs, updateMs, draws, dispatches, objects, gpuBytes,
// cpuBytes, threads, startMs, and idle where it does nothing, with the reason}, game, window, split
// {reference, rmse, relativeRmse, flip} where a picture was compared with a reference, guards, stateHash
// (sixteen hexadecimal digits), other {name: ms}. The bill has a row for every effect of the program (of a
// simulation without graphics those that have a part in it) and "frame", what belongs to none;
// core::EffectStatistics says what its members mean.
std::string statisticsJson(const core::FrameStatistics& statistics);

// Throws core::DataError when the file cannot be written.
void writeStatistics(core::OutputFile& file, const core::FrameStatistics& statistics);

}  // namespace skydrop::app
