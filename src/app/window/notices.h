// Lines that tell the player over the picture what just happened, each for a few seconds.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "skydrop/game/snapshot.h"

namespace skydrop::app {

class Notices {
 public:
  static constexpr double kSeconds = 3;             // to read a few words
  static constexpr double kUnrequestedSeconds = 8;  // to read what nobody asked for

  void add(std::string text, double seconds = kSeconds) { lines_.push_back({std::move(text), seconds}); }
  // Seconds on the wall clock: a pause does not keep them.
  void pass(double seconds) {
    for (game::Message& line : lines_) line.secondsLeft -= seconds;
    std::erase_if(lines_, [](const game::Message& line) { return line.secondsLeft <= 0; });
  }
  // After the game's own messages, oldest first.
  void addTo(game::Snapshot& snapshot) const {
    snapshot.messages.insert(snapshot.messages.end(), lines_.begin(), lines_.end());
  }

 private:
  std::vector<game::Message> lines_;
};

}  // namespace skydrop::app
