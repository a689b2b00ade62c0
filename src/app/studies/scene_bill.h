// What the parts of a scene cost, frame by frame, and what a frame costs more than another one.
#pragma once

#include <vector>

#include "app/studies/measured_game.h"
#include "skydrop/core/frame_statistics.h"

namespace skydrop::app {

// Of so many frames of a game, measured.
struct SceneBill {
  std::vector<double> frameMs;                // of whole frames, by the wall clock
  std::vector<core::FrameStatistics> frames;  // the same frames

  // What the rows of the bill account for, as a share of the whole frame: the median.
  double paidShare() const;
};
SceneBill billOf(MeasuredGame& game, int frames);

// What the frame of one game takes, and how much more that of another one, in turns: whatever else the
// machine does hits both alike. Times in ms, of frames that nothing measures from within.
struct FrameComparison {
  double baseMs = 0, otherMs = 0;                   // medians of all rounds
  double moreMs = 0;                                // by which `other` is above `base`: median of the rounds
  double leastMoreMs = 0, mostMoreMs = 0;           // of the rounds
  double ratio = 1, leastRatio = 1, mostRatio = 1;  // of other to base, likewise
};
FrameComparison compareFrames(MeasuredGame& base, MeasuredGame& other, int rounds);

}  // namespace skydrop::app
