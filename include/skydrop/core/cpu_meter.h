// Adds up the CPU time of a part of the program that comes round again and again: one step, one frame.
#pragma once

#include <cstdint>
#include <utility>

#include "skydrop/core/cpu_clock.h"

namespace skydrop::core {

// Measures only when asked to, and costs a test of a flag otherwise. What is measured must run on the
// caller's thread. A value; nothing that is measured can see it.
class CpuMeter {
 public:
  // From now on, or no longer. What was measured before stays.
  void setMeasuring(bool measuring) { measuring_ = measuring; }

  // Runs the work, which may be one of several in a round. Of work that throws nothing is counted.
  template <class Work>
  void measure(Work&& work) {
    if (!measuring_) {
      std::forward<Work>(work)();
      return;
    }
    const CpuClock clock;
    std::forward<Work>(work)();
    ms_ += clock.ms();
  }
  // After the last work of a round.
  void endRound() { rounds_ += measuring_ ? 1 : 0; }

  std::uint64_t rounds() const { return rounds_; }  // that were measured
  double ms() const { return ms_; }                 // of all of them
  double meanMs() const { return rounds_ > 0 ? ms_ / static_cast<double>(rounds_) : 0; }

 private:
  bool measuring_ = false;
  double ms_ = 0;
  std::uint64_t rounds_ = 0;
};

}  // namespace skydrop::core
