// The measured frame times of a run and what is reported of them. Takes at most 80 KiB however long it runs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "skydrop/core/frame_statistics.h"

namespace skydrop::app {

class FrameTimes {
 public:
  // So many frames are kept one by one.
  static constexpr std::size_t kKept = 4096;
  // Bound of the relative error of a quantile once there are more; up to then quantiles are exact, and
  // extremes always are. Holds for times from kShortestMs to kLongestMs.
  static constexpr double kRelativeError = 0.005;
  static constexpr double kShortestMs = 1e-3, kLongestMs = 1e6;

  void add(double ms);
  // The newest, at most `most` of them and kKept, oldest first. Valid until the next add().
  std::span<const double> newest(std::size_t most) const;
  std::size_t count() const { return count_; }

  // As core::quantileOf, of all frames.
  double quantile(double quantile) const;
  void writeTo(core::FrameStatistics& statistics) const;

 private:
  // A bin holds times whose logarithms lie so close that its middle is off by less than kRelativeError.
  static constexpr double kBinWidth = 1.98 * kRelativeError;
  static constexpr std::size_t kBins = 2100;
  static std::size_t binOf(double ms);

  std::size_t count_ = 0;
  double least_ = 0, most_ = 0;
  std::vector<double> newest_;  // at most twice kKept: the older half is dropped at once
  std::array<std::uint32_t, kBins> bins_{};
};

}  // namespace skydrop::app
