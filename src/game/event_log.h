// What the world tells of itself: messages for the player, which show for a while, and events for sounds and
// tests, which are taken once. Nothing here decides the future.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "skydrop/game/events.h"
#include "skydrop/game/snapshot.h"

namespace skydrop::game {

class EventLog {
 public:
  // Opens the page of this step: messages age by one.
  void beginStep(std::uint64_t step);
  std::uint64_t step() const { return step_; }

  // A message that shows for `seconds`, at least one step.
  void say(std::string text, double seconds);
  void report(GameEventKind kind, const glm::dvec3& position, std::uint32_t id = 0, double missDistance = 0,
              bool onWater = false);
  void report(GameEvent event);  // its step is this one

  // Oldest first.
  std::vector<Message> messages() const;
  // Those of this step that nobody has taken yet, in order; until the next report.
  std::span<const GameEvent> ofStep() const;
  // The events since the last call, in order (the newest 1024).
  std::vector<GameEvent> takeEvents();

 private:
  struct TimedMessage {
    std::string text;
    std::uint64_t stepsLeft = 0;
  };

  std::uint64_t step_ = 0;
  std::vector<TimedMessage> messages_;
  std::vector<GameEvent> events_;
};

}  // namespace skydrop::game
