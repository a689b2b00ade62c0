// Times of a flight that is flown several times and does the same work in the same frame of each: the median
// of a frame over the flights is the program's, what single frames take longer is mostly what else the
// machine does.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "skydrop/core/quantile.h"

namespace skydrop::bench {

class RepeatedFlight {
 public:
  explicit RepeatedFlight(std::size_t frames) : ms_(frames) {}

  void add(std::size_t frame, double ms) { ms_.at(frame).push_back(ms); }

  std::size_t frames() const { return ms_.size(); }
  double medianOf(std::size_t frame) const { return core::quantileOf(ms_.at(frame), 0.5); }

  // Of all frames the median over the flights, in their order.
  std::vector<double> medians() const {
    std::vector<double> medians;
    for (std::size_t frame = 0; frame < ms_.size(); ++frame) medians.push_back(medianOf(frame));
    return medians;
  }

  // Every frame of every flight.
  std::vector<double> all() const {
    std::vector<double> all;
    for (const std::vector<double>& ms : ms_) all.insert(all.end(), ms.begin(), ms.end());
    return all;
  }

  // Share of all frames that took moreMs longer than their median.
  double shareOfLong(double moreMs) const {
    std::size_t count = 0;
    for (const std::vector<double>& ms : ms_) {
      const double median = core::quantileOf(ms, 0.5);
      count += static_cast<std::size_t>(
          std::ranges::count_if(ms, [&](double one) { return one >= median + moreMs; }));
    }
    return static_cast<double>(count) / static_cast<double>(all().size());
  }

 private:
  std::vector<std::vector<double>> ms_;  // of a frame, by flight
};

}  // namespace skydrop::bench
