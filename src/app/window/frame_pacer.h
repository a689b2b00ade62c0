// When the next frame may begin: a cap on the frame rate with even intervals. Main thread.
#pragma once

#include <chrono>

namespace skydrop::app {

// The times of frames that are `period` apart. Pure: the present is passed in.
class FrameSchedule {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;
  using Duration = std::chrono::steady_clock::duration;

  // When the frame after the one that ended `now` may begin. Times lie on one grid, so that waits that end a
  // little late do not add up; a frame that missed its time by more than a period starts a new grid instead
  // of being followed by a burst. A period <= 0: at once.
  TimePoint next(TimePoint now, Duration period);

 private:
  TimePoint last_{};
  Duration period_{0};
};

// Waits for those times: sleeps while that is safe, and spins for the rest. How late a sleep wakes is learnt
// as it goes: about 0.1 ms on an idle Linux machine, so the spin costs little of a frame.
class FramePacer {
 public:
  // Returns when the next frame may begin; hertz <= 0: at once.
  void wait(double hertz);

 private:
  FrameSchedule schedule_;
  std::chrono::duration<double> margin_{0.001};  // before the time, s: from here on it spins
};

}  // namespace skydrop::app
