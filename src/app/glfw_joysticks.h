// The joysticks of this machine, by GLFW; needs a window (render::gl::WindowContext). One at a time, main
// thread.
#pragma once

#include <filesystem>

#include "app/gamepads.h"

namespace skydrop::app {

class GlfwJoysticks final : public JoystickSource {
 public:
  // `mappings`: a file in the form of SDL's gamecontrollerdb.txt, for devices that GLFW does not know; need
  // not be there. Throws core::DataError if it cannot be read.
  explicit GlfwJoysticks(const std::filesystem::path& mappings);
  ~GlfwJoysticks() override;
  GlfwJoysticks(const GlfwJoysticks&) = delete;
  GlfwJoysticks& operator=(const GlfwJoysticks&) = delete;

  bool takeChange() override;
  std::vector<Joystick> list() override;
  std::optional<GamepadState> read(int id) override;
};

// What stands on the player's keys where it is a printable ASCII character.
KeyLabels keyboardLabels();

}  // namespace skydrop::app
