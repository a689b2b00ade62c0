#include "app/input/player_controls.h"

#include <utility>

namespace skydrop::app {
namespace {

using render::gl::WindowEvent;

// The key that steers a menu like this input; nothing for others.
std::optional<int> menuKey(InputCode input) {
  if (input == buttonInput(pad::kUp) || input == axisInput(pad::kLeftY, false)) return key::kUp;
  if (input == buttonInput(pad::kDown) || input == axisInput(pad::kLeftY, true)) return key::kDown;
  if (input == buttonInput(pad::kA)) return key::kEnter;
  return std::nullopt;
}

}  // namespace

PlayerControls::PlayerControls(Bindings& bindings, const GamepadSettings& settings, JoystickSource& joysticks)
    : bindings_(bindings), settings_(settings), gamepads_(joysticks), input_(bindings), editor_(bindings) {}

bool PlayerControls::handle(const WindowEvent& event, bool typing) {
  if (editor_.offer(event)) {
    if (editor_.takeChange()) bindingsWereReplaced();
    return true;
  }
  input_.handle(event, typing);
  return false;
}

std::vector<WindowEvent> PlayerControls::pollGamepad(bool menuTakesIt) {
  const std::optional<GamepadState> state = gamepads_.poll();
  const GamepadReading reading = state ? readingOf(*state, settings_) : GamepadReading();
  const bool editing = editor_.isWaiting();
  std::vector<WindowEvent> keys;
  for (const InputCode input : input_.handle(reading, settings_, menuTakesIt || editing)) {
    if (editing) {
      editor_.offer(input);
    } else if (input == buttonInput(pad::kB) || bindings_.actionOf(input) == Action::escape) {
      input_.act(Action::escape);
    } else if (const auto code = menuKey(input)) {
      for (const bool pressed : {true, false}) {
        keys.push_back({WindowEvent::Kind::key});
        keys.back().code = *code;
        keys.back().pressed = pressed;
      }
    }
  }
  if (editor_.takeChange()) bindingsWereReplaced();
  if (shownGamepad_ != gamepads_.name()) {
    shownGamepad_ = gamepads_.name();
    changed_ = true;
  }
  return keys;
}

void PlayerControls::apply(const ui::BindingRequest& request) {
  editor_.apply(request);
  if (editor_.takeChange()) bindingsWereReplaced();
}

void PlayerControls::bindingsWereReplaced() {
  input_.setBindings(bindings_);
  changed_ = true;
}

bool PlayerControls::takeChange() { return std::exchange(changed_, false); }

std::vector<ui::HelpRow> PlayerControls::help() const {
  return helpRows(bindings_, !gamepads_.name().empty(), keyLabels_);
}

ui::HudKeys PlayerControls::hudKeys() const {
  const auto first = [this](Action action) {
    const std::vector<InputCode>& inputs = bindings_.inputsOf(action);
    return inputs.empty() ? std::string() : inputLabel(inputs.front(), keyLabels_);
  };
  return {first(Action::drop), first(Action::pause), first(Action::help), first(Action::reset)};
}

std::string PlayerControls::keyOf(std::initializer_list<Action> actions) const {
  std::string text;
  for (const Action action : actions) {
    const std::vector<InputCode>& inputs = bindings_.inputsOf(action);
    if (inputs.empty()) continue;
    if (!text.empty()) text += ' ';
    text += inputLabel(inputs.front(), keyLabels_);
  }
  return text.empty() ? "\u2013" : text;
}

void PlayerControls::setKeyLabels(KeyLabels labels) {
  keyLabels_ = std::move(labels);
  changed_ = true;
}

}  // namespace skydrop::app
