// The joysticks of this machine, by GLFW; needs a window (render::gl::WindowContext). One at a time, main
// thread.
#pragma once

#include <filesystem>
#include <string>

#include "app/input/gamepads.h"

namespace skydrop::app {

class GlfwJoysticks final : public JoystickSource {
 public:
  // `mappings`: a file in the form of SDL's gamecontrollerdb.txt, for devices that GLFW does not know; need
  // not be there. One that cannot be read is left out: see warning().
  explicit GlfwJoysticks(const std::filesystem::path& mappings);
  ~GlfwJoysticks() override;
  GlfwJoysticks(const GlfwJoysticks&) = delete;
  GlfwJoysticks& operator=(const GlfwJoysticks&) = delete;

  // Why the mappings were not read; empty when they were, or when there are none.
  const std::string& warning() const { return warning_; }

  bool takeChange() override;
  std::vector<Joystick> list() override;
  std::optional<GamepadState> read(int id) override;

 private:
  std::string warning_;
};

// What stands on the player's keys where it is a printable ASCII character.
KeyLabels keyboardLabels();

}  // namespace skydrop::app
