#include "app/measure/frame_times.h"

#include <algorithm>
#include <cmath>

#include "skydrop/core/quantile.h"

namespace skydrop::app {

std::size_t FrameTimes::binOf(double ms) {
  static_assert(kBins * kBinWidth > 20.73, "ln(kLongestMs / kShortestMs) is 20.72");
  const double bin = std::log(std::max(ms, kShortestMs) / kShortestMs) / kBinWidth;
  return std::min(static_cast<std::size_t>(bin), kBins - 1);
}

void FrameTimes::add(double ms) {
  least_ = count_ == 0 ? ms : std::min(least_, ms);
  most_ = count_ == 0 ? ms : std::max(most_, ms);
  ++count_;
  ++bins_[binOf(ms)];
  if (newest_.size() == 2 * kKept) newest_.erase(newest_.begin(), newest_.end() - kKept);
  newest_.push_back(ms);
}

std::span<const double> FrameTimes::newest(std::size_t most) const {
  return std::span(newest_).last(std::min({most, newest_.size(), kKept}));
}

double FrameTimes::quantile(double quantile) const {
  if (count_ == 0) return 0;
  if (count_ <= kKept) return core::quantileOf(newest_, quantile);
  const std::size_t rank = core::quantileRank(count_, quantile);
  if (rank == 0) return least_;
  if (rank + 1 >= count_) return most_;
  std::size_t bin = 0, below = 0;
  while (bin + 1 < kBins && below + bins_[bin] <= rank) below += bins_[bin++];
  const double middle = kShortestMs * std::exp((static_cast<double>(bin) + 0.5) * kBinWidth);
  return std::clamp(middle, least_, most_);
}

void FrameTimes::writeTo(core::FrameStatistics& statistics) const {
  statistics.frames = static_cast<std::int64_t>(count_);
  statistics.medianMs = quantile(0.5);
  statistics.p99Ms = quantile(0.99);
  statistics.maxMs = count_ > 0 ? most_ : 0;
}

}  // namespace skydrop::app
