#include "app/frame_times.h"

#include <algorithm>
#include <cmath>

namespace skydrop::app {

std::span<const double> FrameTimes::newest(std::size_t most) const {
  return std::span(ms_).last(std::min(most, ms_.size()));
}

double FrameTimes::quantile(double quantile) const {
  if (ms_.empty()) return 0;
  std::vector<double> sorted = ms_;
  const double rank = std::ceil(quantile * static_cast<double>(sorted.size())) - 1;
  const auto nth = sorted.begin() + static_cast<std::ptrdiff_t>(std::max(rank, 0.0));
  std::nth_element(sorted.begin(), nth, sorted.end());
  return *nth;
}

void FrameTimes::writeTo(core::FrameStatistics& statistics) const {
  statistics.frames = static_cast<std::int64_t>(ms_.size());
  statistics.medianMs = quantile(0.5);
  statistics.p99Ms = quantile(0.99);
  statistics.maxMs = quantile(1);
}

}  // namespace skydrop::app
