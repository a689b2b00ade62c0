#define GLFW_INCLUDE_NONE
#include "app/input/glfw_joysticks.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "skydrop/core/error.h"
#include "skydrop/core/file.h"

namespace skydrop::app {
namespace {

constexpr std::size_t kMostBytes = std::size_t{4} << 20;  // SDL's own is half a megabyte

bool changed = true;  // GLFW's callback knows no owner

static_assert(pad::kButtons == GLFW_GAMEPAD_BUTTON_LAST + 1 && pad::kAxes == GLFW_GAMEPAD_AXIS_LAST + 1);
static_assert(pad::kLeft == GLFW_GAMEPAD_BUTTON_DPAD_LEFT &&
              pad::kRightTrigger == GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER);
static_assert(key::kRightSuper == GLFW_KEY_RIGHT_SUPER && key::kF25 == GLFW_KEY_F25 &&
              key::kLast == GLFW_KEY_LAST);

}  // namespace

GlfwJoysticks::GlfwJoysticks(const std::filesystem::path& mappings) {
  std::error_code ignored;
  if (std::filesystem::exists(mappings, ignored)) {
    try {
      const std::string text = core::readTextFile(mappings, kMostBytes);
      if (text.find('\0') != std::string::npos)
        throw core::DataError(mappings.string(), "mappings", "a zero byte: not a text file");
      glfwUpdateGamepadMappings(text.c_str());
    } catch (const core::DataError& error) {
      warning_ = error.what();
    }
  }
  changed = true;
  glfwSetJoystickCallback([](int, int) { changed = true; });
}

GlfwJoysticks::~GlfwJoysticks() { glfwSetJoystickCallback(nullptr); }

bool GlfwJoysticks::takeChange() { return std::exchange(changed, false); }

std::vector<Joystick> GlfwJoysticks::list() {
  std::vector<Joystick> joysticks;
  for (int id = GLFW_JOYSTICK_1; id <= GLFW_JOYSTICK_LAST; ++id) {
    if (!glfwJoystickPresent(id)) continue;
    const bool mapped = glfwJoystickIsGamepad(id) == GLFW_TRUE;
    const char* name = mapped ? glfwGetGamepadName(id) : glfwGetJoystickName(id);
    joysticks.push_back({id, name ? name : "without a name", mapped});
  }
  return joysticks;
}

std::optional<GamepadState> GlfwJoysticks::read(int id) {
  GLFWgamepadstate read;
  if (!glfwGetGamepadState(id, &read)) return std::nullopt;
  GamepadState state;
  for (std::size_t i = 0; i < state.buttons.size(); ++i) state.buttons[i] = read.buttons[i] == GLFW_PRESS;
  std::copy_n(read.axes, state.axes.size(), state.axes.begin());
  return state;
}

KeyLabels keyboardLabels() {
  KeyLabels labels;
  for (int code = key::kSpace + 1; code < 127; ++code) {
    if (inputName(keyInput(code)).empty()) continue;
    const char* name = glfwGetKeyName(code, 0);
    if (!name || !name[0] || name[1]) continue;  // the typeface of the interface has ASCII
    const auto c = static_cast<unsigned char>(name[0]);
    if (std::isgraph(c)) labels[code] = std::string(1, static_cast<char>(std::toupper(c)));
  }
  return labels;
}

}  // namespace skydrop::app
