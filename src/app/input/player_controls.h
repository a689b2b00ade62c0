// Everything between the player's hands and the game: keyboard, gamepads, bindings and their editor. Main
// thread.
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "app/input/binding_editor.h"
#include "app/input/gamepads.h"
#include "app/input/player_input.h"

namespace skydrop::app {

class PlayerControls {
 public:
  // The bindings are changed by the player; all three must outlive this.
  PlayerControls(Bindings& bindings, const GamepadSettings& settings, JoystickSource& joysticks);

  PlayerInput& input() { return input_; }

  // Before every other reader of the event: true if the editor took it. `typing`: see PlayerInput::handle.
  bool handle(const render::gl::WindowEvent& event, bool typing);
  // Once a frame, after the events. `menuTakesIt`: a menu that is steered by arrows and Enter is open; the
  // keys that the gamepad presses in it are returned, each pressed and released.
  std::vector<render::gl::WindowEvent> pollGamepad(bool menuTakesIt);

  void apply(const ui::BindingRequest& request);
  // The bindings were changed from elsewhere (the player's file).
  void bindingsWereReplaced();
  // A menu that shows the editor was closed.
  void stopWaiting() { editor_.cancel(); }

  // True in the first call, and whenever another key or gamepad has to be shown since the last.
  bool takeChange();
  std::vector<ui::HelpRow> help() const;
  ui::HudKeys hudKeys() const;
  // What stands on the first input of each, as the keyboard has it; a dash where none does any of it.
  std::string keyOf(std::initializer_list<Action> actions) const;
  ui::BindingsContent menuContent() const { return editor_.content(keyLabels_, gamepads_.name()); }
  std::vector<GamepadMessage> takeMessages() { return gamepads_.takeMessages(); }

  // What stands on the player's keyboard.
  void setKeyLabels(KeyLabels labels);

 private:
  Bindings& bindings_;
  const GamepadSettings& settings_;
  Gamepads gamepads_;
  std::string shownGamepad_;
  PlayerInput input_;
  BindingEditor editor_;
  KeyLabels keyLabels_;
  bool changed_ = true;
};

}  // namespace skydrop::app
