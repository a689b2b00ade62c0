#include "app/session/clock_pace.h"

namespace skydrop::app {

bool ClockPace::follow(render::SunSettings& sun, double simulatedSeconds) {
  if (!scale_) {
    scale_ = sun.timeScale;
    offset_ = first_ = sun.offsetSeconds;
    return false;
  }
  if (sun.timeScale != *scale_) {
    offset_ += (*scale_ - sun.timeScale) * simulatedSeconds;
    scale_ = sun.timeScale;
  }
  if (sun.offsetSeconds == offset_) return false;
  sun.offsetSeconds = offset_;
  return true;
}

void ClockPace::restart() {
  if (scale_) offset_ = first_;
}

}  // namespace skydrop::app
