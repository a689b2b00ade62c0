// The clock between real time and simulated time. Real seconds go in, a number of whole steps comes out.
// Simulated time is an integer count of steps: it has no rounding error that grows with the uptime, and two
// runs that did the same steps are at the same time exactly. Not thread-safe: the main thread owns it.
#pragma once

#include <cstdint>

namespace skydrop::core {

class FixedStep {
 public:
  static constexpr int kStepsPerSecond = 120;
  static constexpr double kStepSeconds = 1.0 / kStepsPerSecond;
  // After a stall (loading, a debugger, a laptop lid) at most this much is caught up; the rest of the stall
  // never happened for the simulation. It also bounds a frame's work where a step costs more than it
  // simulates: simulated time then runs slower than real time instead of falling further behind.
  static constexpr double kMaxCatchUpSeconds = 0.25;

  // How many steps are due after `realSeconds` more of real time: 0 to 30. A value <= 0 or not finite
  // changes nothing and gives 0; the not finite ones are counted (Guard::clockStep).
  int advance(double realSeconds);

  // How far the present lies between the last step (0) and the next (1, not reached): what a view uses to
  // interpolate.
  double alpha() const { return pending_; }

  // Drops the started step, as after a pause: the next frame starts at a step exactly.
  void discardPending() { pending_ = 0; }

  std::uint64_t stepCount() const { return steps_; }
  double simulatedSeconds() const { return secondsOf(steps_); }

  // The time of a step, rounded once (under a microsecond up to 1e9 s).
  static constexpr double secondsOf(std::uint64_t steps) {
    return static_cast<double>(steps / kStepsPerSecond) +
           static_cast<double>(steps % kStepsPerSecond) / kStepsPerSecond;
  }

 private:
  std::uint64_t steps_ = 0;
  double pending_ = 0;  // share of a step that has passed, in [0, 1)
};

}  // namespace skydrop::core
