// Keeps the clock of the sky from jumping when its speed changes in flight.
#pragma once

#include <optional>

#include "skydrop/render/frame/render_settings.h"

namespace skydrop::app {

// The clock is a function of the settings and of simulated time (SunSettings): utc + shifts + offsetSeconds +
// simulated seconds * timeScale. A change of timeScale alone would multiply the seconds that have passed
// already; offsetSeconds takes up the difference, so that the clock goes on from where it is. The base thus
// lives in a setting: a frame stays a function of its state.
class ClockPace {
 public:
  // After settings may have changed, and before they are drawn: sets sun.offsetSeconds. simulatedSeconds: of
  // the frame that was seen last. True where it has changed something.
  bool follow(render::SunSettings& sun, double simulatedSeconds);
  // The offset that is set now is what the player wants it to be (not what composed layers come to).
  void take(const render::SunSettings& sun) { offset_ = sun.offsetSeconds; }
  // Simulated time begins again: the clock too.
  void restart();

 private:
  std::optional<double> scale_;  // that was in force last
  double offset_ = 0, first_ = 0;
};

}  // namespace skydrop::app
