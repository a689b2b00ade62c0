// The measured frame times of a run and what is said of them.
#pragma once

#include <span>
#include <vector>

#include "skydrop/core/frame_statistics.h"

namespace skydrop::app {

class FrameTimes {
 public:
  void add(double ms) { ms_.push_back(ms); }
  // The newest, at most `most` of them, oldest first. Valid until the next add().
  std::span<const double> newest(std::size_t most) const;
  std::size_t count() const { return ms_.size(); }

  // The value below which the share `quantile` in [0, 1] of the frames lies (nearest rank); 0 without frames.
  double quantile(double quantile) const;
  void writeTo(core::FrameStatistics& statistics) const;

 private:
  std::vector<double> ms_;
};

}  // namespace skydrop::app
