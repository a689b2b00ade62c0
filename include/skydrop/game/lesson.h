// A lesson of three steps that one learns by doing: turn to the target, change the height, deliver. Watches
// snapshots and decides nothing of the flight. A value.
#pragma once

#include <cstdint>
#include <optional>

#include "skydrop/game/snapshot.h"

namespace skydrop::game {

class Lesson {
 public:
  enum class Step { turn, height, drop, done };

  // Once a step of the world, with the state after it; the step of the lesson from now on. It goes on when
  // the target lies ahead with level wings (turn), when the height has changed by kHeightM (height), and when
  // a package has hit (drop). Without aircraft, without target and after a crash it waits.
  Step update(const Snapshot& now);
  Step step() const { return step_; }

  static constexpr double kAheadRad = 0.14, kLevelRad = 0.18, kHeightM = 50;

 private:
  Step step_ = Step::turn;
  std::optional<double> heightM_;
  std::optional<std::int64_t> score_;
};

}  // namespace skydrop::game
