#include "game/event_log.h"

#include <algorithm>
#include <utility>

#include "game/steps.h"

namespace skydrop::game {
namespace {

// Events that nobody takes are kept up to this many, the newest.
constexpr std::size_t kMostEvents = 1024;

}  // namespace

void EventLog::beginStep(std::uint64_t step) {
  step_ = step;
  for (TimedMessage& message : messages_) --message.stepsLeft;
  std::erase_if(messages_, [](const TimedMessage& message) { return message.stepsLeft == 0; });
}

void EventLog::say(std::string text, double seconds) {
  messages_.push_back({std::move(text), std::max<std::uint64_t>(stepsOf(seconds), 1)});
}

void EventLog::report(GameEventKind kind, const glm::dvec3& position, std::uint32_t id, double missDistance,
                      bool onWater) {
  report({.kind = kind, .position = position, .id = id, .missDistance = missDistance, .onWater = onWater});
}

void EventLog::report(GameEvent event) {
  if (events_.size() == kMostEvents) events_.erase(events_.begin());
  event.step = step_;
  events_.push_back(event);
}

std::vector<Message> EventLog::messages() const {
  std::vector<Message> out;
  for (const TimedMessage& message : messages_) out.push_back({message.text, secondsOf(message.stepsLeft)});
  return out;
}

std::span<const GameEvent> EventLog::ofStep() const {
  const auto first = std::ranges::find_if(events_, [&](const GameEvent& e) { return e.step == step_; });
  return {first, events_.end()};
}

std::vector<GameEvent> EventLog::takeEvents() { return std::exchange(events_, {}); }

}  // namespace skydrop::game
