#include "app/player_input.h"

#include <algorithm>
#include <utility>

namespace skydrop::app {
namespace {

using render::gl::WindowEvent;

// One step towards -kRampSteps, 0 or kRampSteps; returns the level as a share.
double ramp(int& level, int direction) {
  level += std::clamp(direction * kRampSteps - level, -1, 1);
  return static_cast<double>(level) / kRampSteps;
}

}  // namespace

PlayerInput::PlayerInput(KeyMap keys) : keys_(std::move(keys)) {}

void PlayerInput::handle(const WindowEvent& event, bool typing) {
  if (event.kind == WindowEvent::Kind::focus && !event.pressed) heldKeys_.clear();
  if (event.kind != WindowEvent::Kind::key) return;
  if (!event.pressed) {
    heldKeys_.erase(event.code);
    return;
  }
  if (typing || event.repeated) return;
  const std::optional<Action> action = keys_.actionOf(event.code);
  if (!action) return;
  if (!isFlightAction(*action)) {
    actions_.push_back(*action);
    return;
  }
  heldKeys_.insert(event.code);
  if (*action == Action::drop) dropTapped_ = true;
  if (*action == Action::reset) resetTapped_ = true;
}

bool PlayerInput::isHeld(Action action) const {
  return std::ranges::any_of(heldKeys_, [&](int code) { return keys_.actionOf(code) == action; });
}

game::Controls PlayerInput::step() {
  const auto axis = [this](Action negative, Action positive) {
    return (isHeld(positive) ? 1 : 0) - (isHeld(negative) ? 1 : 0);
  };
  game::Controls controls;
  controls.thrust = ramp(thrust_, isHeld(Action::thrust) ? 1 : 0);
  controls.brake = ramp(brake_, isHeld(Action::brake) ? 1 : 0);
  controls.pitch = ramp(pitch_, axis(Action::noseDown, Action::noseUp));
  controls.roll = ramp(roll_, axis(Action::rollLeft, Action::rollRight));
  controls.yaw = ramp(yaw_, axis(Action::yawLeft, Action::yawRight));
  controls.drop = std::exchange(dropTapped_, false) || isHeld(Action::drop);
  controls.reset = std::exchange(resetTapped_, false) || isHeld(Action::reset);
  return controls;
}

void PlayerInput::forgetTaps() { dropTapped_ = resetTapped_ = false; }

std::vector<Action> PlayerInput::takeActions() { return std::exchange(actions_, {}); }

}  // namespace skydrop::app
