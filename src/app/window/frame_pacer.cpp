#include "app/window/frame_pacer.h"

#include <algorithm>
#include <thread>

namespace skydrop::app {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr Seconds kLeastMargin{0.0002},
    kMostMargin{0.002};           // a machine that wakes later than 2 ms is overloaded
constexpr double kForget = 0.98;  // a frame: a single late wake is forgotten within a second or two

}  // namespace

FrameSchedule::TimePoint FrameSchedule::next(TimePoint now, Duration period) {
  const TimePoint due = last_ + period;
  const bool onGrid = period == period_ && now <= due + period;
  period_ = period;
  last_ = period > Duration::zero() && onGrid ? due : now;
  return last_;
}

void FramePacer::wait(double hertz) {
  const Seconds period(hertz > 0 ? 1 / hertz : 0);
  const Clock::time_point due =
      schedule_.next(Clock::now(), std::chrono::duration_cast<Clock::duration>(period));
  const Clock::time_point wake = due - std::chrono::duration_cast<Clock::duration>(margin_);
  if (Clock::now() < wake) {
    std::this_thread::sleep_until(wake);
    const Seconds late = Clock::now() - wake;
    margin_ = std::clamp(std::max(margin_ * kForget, late * 1.5), kLeastMargin, kMostMargin);
  }
  while (Clock::now() < due) {
  }
}

}  // namespace skydrop::app
