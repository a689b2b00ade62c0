// Something that can be pressed or pushed: a key, a button of a gamepad, or one direction of one of its axes.
// Codes are GLFW's (GLFW/glfw3.h), as plain integers: a test needs no window library.
#pragma once

#include <compare>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace skydrop::app {

namespace key {
inline constexpr int kSpace = 32, kEscape = 256, kEnter = 257, kTab = 258, kBackspace = 259, kInsert = 260,
                     kDelete = 261, kRight = 262, kLeft = 263, kDown = 264, kUp = 265, kPageUp = 266,
                     kPageDown = 267, kHome = 268, kEnd = 269, kF1 = 290, kF2 = 291, kF3 = 292, kF11 = 300,
                     kF12 = 301, kF25 = 314, kKeypad0 = 320, kKeypad9 = 329, kKeypadEnter = 335,
                     kLeftShift = 340, kLeftControl = 341, kLeftAlt = 342, kLeftSuper = 343,
                     kRightShift = 344, kRightControl = 345, kRightAlt = 346, kRightSuper = 347, kLast = 348;
// Letters and digits are their capital ASCII codes. A code is a place on the keyboard, named by what stands
// there on an American one.
}  // namespace key

// Of a gamepad as GLFW's mappings see it: that of an Xbox, whatever is written on the buttons.
namespace pad {
inline constexpr int kA = 0, kB = 1, kX = 2, kY = 3, kLeftBumper = 4, kRightBumper = 5, kBack = 6, kStart = 7,
                     kGuide = 8, kLeftThumb = 9, kRightThumb = 10, kUp = 11, kRight = 12, kDown = 13,
                     kLeft = 14, kButtons = 15;
inline constexpr int kLeftX = 0, kLeftY = 1, kRightX = 2, kRightY = 3, kLeftTrigger = 4, kRightTrigger = 5,
                     kAxes = 6;
}  // namespace pad

struct InputCode {
  enum class Device { key, button, axisPositive, axisNegative };
  Device device = Device::key;
  int code = 0;

  bool isKey() const { return device == Device::key; }
  bool isAxis() const { return device == Device::axisPositive || device == Device::axisNegative; }
  auto operator<=>(const InputCode&) const = default;
};

inline constexpr InputCode keyInput(int code) { return {InputCode::Device::key, code}; }
inline constexpr InputCode buttonInput(int code) { return {InputCode::Device::button, code}; }
// Down and right are positive.
inline constexpr InputCode axisInput(int code, bool positive) {
  return {positive ? InputCode::Device::axisPositive : InputCode::Device::axisNegative, code};
}

// As the settings file names it: GLFW's name without GLFW_ and KEY_, and a sign for an axis. "W",
// "LEFT_SHIFT", "GAMEPAD_BUTTON_A", "GAMEPAD_AXIS_LEFT_X-". Empty for a code that has no name.
std::string inputName(InputCode input);
std::optional<InputCode> inputNamed(std::string_view name);

// What stands on a key of the player's keyboard, by code, where it differs from an American one.
using KeyLabels = std::map<int, std::string>;

// As the player reads it, short: "W", "Space", "\u2190"; of a gamepad in parentheses: "(A)", "(LS\u2190)".
std::string inputLabel(InputCode input, const KeyLabels& keys = {});

}  // namespace skydrop::app
