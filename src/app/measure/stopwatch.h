// How long something takes on the wall clock, from the watch's construction on.
#pragma once

#include <chrono>

namespace skydrop::app {

class Stopwatch {
 public:
  double ms() const { return passed<std::milli>(); }
  double seconds() const { return passed<std::ratio<1>>(); }

 private:
  template <class Unit>
  double passed() const {
    return std::chrono::duration<double, Unit>(std::chrono::steady_clock::now() - begin_).count();
  }

  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace skydrop::app
