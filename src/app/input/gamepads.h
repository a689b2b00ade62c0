// Which gamepad is flown with, among those that come and go. What is reported about them is reported once.
// Main thread.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/input/gamepad.h"

namespace skydrop::app {

struct Joystick {
  int id = 0;
  std::string name;
  bool isMapped = false;  // it can be read as a gamepad
};

// Where joysticks come from: GLFW in the game (glfw_joysticks.h), a list in a test.
class JoystickSource {
 public:
  virtual ~JoystickSource() = default;

  // True when the list may have changed since the last call; in the first call.
  virtual bool takeChange() = 0;
  virtual std::vector<Joystick> list() = 0;
  // Nothing if it is gone or not mapped.
  virtual std::optional<GamepadState> read(int id) = 0;
};

struct GamepadMessage {
  std::string text;
  bool isNews = true;  // false: the usual state of things, not worth a line in the picture
};

class Gamepads {
 public:
  explicit Gamepads(JoystickSource& source) : source_(source) {}

  // Once a frame: the state of the gamepad in use, the one with the lowest number; nothing without one.
  std::optional<GamepadState> poll();

  // Of the gamepad in use; empty without one.
  const std::string& name() const { return name_; }

  // What there is to say since the last call: a gamepad that came or went, a joystick without mapping (each
  // name once), and at first that there is none.
  std::vector<GamepadMessage> takeMessages();

 private:
  void look();

  JoystickSource& source_;
  std::optional<int> id_;
  std::string name_;
  bool looked_ = false;
  std::set<std::string> unmapped_;  // said already
  std::vector<GamepadMessage> messages_;
};

}  // namespace skydrop::app
