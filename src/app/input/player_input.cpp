#include "app/input/player_input.h"

#include <algorithm>
#include <utility>

namespace skydrop::app {
namespace {

using render::gl::WindowEvent;

// Keys and gamepad fly together.
double together(double keys, double gamepad) { return std::clamp(keys + gamepad, -1.0, 1.0); }

// Has more than on and off: an axis is not pressed for it, but pushed.
bool isLevel(Action action) { return action <= Action::yawRight; }

std::vector<InputCode> gamepadInputs() {
  std::vector<InputCode> all;
  for (int i = 0; i < pad::kButtons; ++i) all.push_back(buttonInput(i));
  for (int i = 0; i < pad::kAxes; ++i) all.insert(all.end(), {axisInput(i, false), axisInput(i, true)});
  return all;
}

}  // namespace

GamepadPresses::Changes GamepadPresses::update(const GamepadReading& reading) {
  static const std::vector<InputCode> kInputs = gamepadInputs();
  Changes changes;
  for (const InputCode input : kInputs) {
    const double strength = reading.strength(input);
    if (strength > kAxisPressed && down_.insert(input).second) changes.pressed.push_back(input);
    if (strength < kAxisFree && down_.erase(input) > 0) changes.freed.push_back(input);
  }
  return changes;
}

PlayerInput::PlayerInput(Bindings bindings) : bindings_(std::move(bindings)) {}

void PlayerInput::setBindings(const Bindings& bindings) {
  bindings_ = bindings;
  held_.clear();
  tapped_.clear();
}

void PlayerInput::handle(const WindowEvent& event, bool typing) {
  if (event.kind == WindowEvent::Kind::focus) {
    focused_ = event.pressed;
    if (!focused_) {
      held_.clear();
      tapped_.clear();
    }
  }
  if (event.kind != WindowEvent::Kind::key) return;
  if (!event.pressed) {
    held_.erase(keyInput(event.code));
  } else if (!typing && !event.repeated) {
    press(keyInput(event.code));
  }
}

std::vector<InputCode> PlayerInput::handle(const GamepadReading& reading, const GamepadSettings& settings,
                                           bool taken) {
  const GamepadPresses::Changes changes = gamepadPresses_.update(reading);
  for (const InputCode input : changes.freed) held_.erase(input);
  gamepad_ = focused_ && !taken ? reading : GamepadReading();
  gamepadSettings_ = settings;
  if (!focused_) return {};
  if (taken) return changes.pressed;
  for (const InputCode input : changes.pressed) press(input);
  return {};
}

void PlayerInput::press(InputCode input) {
  const std::optional<Action> action = bindings_.actionOf(input);
  if (!action || (input.isAxis() && isLevel(*action))) return;
  if (!isFlightAction(*action)) {
    actions_.push_back(*action);
    return;
  }
  held_.insert(input);
  tapped_.insert(input);
}

bool PlayerInput::isHeld(Action action) const {
  const auto moves = [&](InputCode input) { return bindings_.actionOf(input) == action; };
  return std::ranges::any_of(held_, moves) || std::ranges::any_of(tapped_, moves);
}

// By an axis, 0 .. 1.
double PlayerInput::pushed(Action action) const {
  double most = 0;
  for (const InputCode input : bindings_.inputsOf(action)) {
    if (input.isAxis()) most = std::max(most, gamepad_.strength(input));
  }
  return most;
}

double PlayerInput::pushed(Action negative, Action positive, bool inverted) const {
  const double level = pushed(positive) - pushed(negative);
  return inverted ? -level : level;
}

game::Controls PlayerInput::step() {
  const auto axis = [this](Action negative, Action positive) {
    return (isHeld(positive) ? 1 : 0) - (isHeld(negative) ? 1 : 0);
  };
  const GamepadSettings& pad = gamepadSettings_;
  game::Controls controls;
  controls.thrust = together(thrust_.step(isHeld(Action::thrust) ? 1 : 0), pushed(Action::thrust));
  controls.brake = together(brake_.step(isHeld(Action::brake) ? 1 : 0), pushed(Action::brake));
  controls.pitch = together(pitch_.step(axis(Action::noseDown, Action::noseUp)),
                            pushed(Action::noseDown, Action::noseUp, pad.invertPitch));
  controls.roll = together(roll_.step(axis(Action::rollLeft, Action::rollRight)),
                           pushed(Action::rollLeft, Action::rollRight, pad.invertRoll));
  controls.yaw = together(yaw_.step(axis(Action::yawLeft, Action::yawRight)),
                          pushed(Action::yawLeft, Action::yawRight, pad.invertYaw));
  controls.drop = isHeld(Action::drop);
  controls.reset = isHeld(Action::reset);
  tapped_.clear();
  return controls;
}

void PlayerInput::forgetTaps() { tapped_.clear(); }

std::vector<Action> PlayerInput::takeActions() { return std::exchange(actions_, {}); }

}  // namespace skydrop::app
