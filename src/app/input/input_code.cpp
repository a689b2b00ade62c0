#include "app/input/input_code.h"

#include <array>

namespace skydrop::app {
namespace {

struct Named {
  int code;
  const char* name;   // GLFW's
  const char* label;  // null: the name itself
};

constexpr Named kKeys[] = {{32, "SPACE", "Space"},
                           {39, "APOSTROPHE", "'"},
                           {44, "COMMA", ","},
                           {45, "MINUS", "-"},
                           {46, "PERIOD", "."},
                           {47, "SLASH", "/"},
                           {59, "SEMICOLON", ";"},
                           {61, "EQUAL", "="},
                           {91, "LEFT_BRACKET", "["},
                           {92, "BACKSLASH", "\\"},
                           {93, "RIGHT_BRACKET", "]"},
                           {96, "GRAVE_ACCENT", "`"},
                           {161, "WORLD_1", "World 1"},
                           {162, "WORLD_2", "World 2"},
                           {256, "ESCAPE", "Esc"},
                           {257, "ENTER", "Enter"},
                           {258, "TAB", "Tab"},
                           {259, "BACKSPACE", "Backspace"},
                           {260, "INSERT", "Insert"},
                           {261, "DELETE", "Delete"},
                           {262, "RIGHT", "\u2192"},
                           {263, "LEFT", "\u2190"},
                           {264, "DOWN", "\u2193"},
                           {265, "UP", "\u2191"},
                           {266, "PAGE_UP", "Page \u2191"},
                           {267, "PAGE_DOWN", "Page \u2193"},
                           {268, "HOME", "Home"},
                           {269, "END", "End"},
                           {280, "CAPS_LOCK", "Caps"},
                           {281, "SCROLL_LOCK", "Scroll"},
                           {282, "NUM_LOCK", "Num"},
                           {283, "PRINT_SCREEN", "Print"},
                           {284, "PAUSE", "Pause"},
                           {330, "KP_DECIMAL", "Num ."},
                           {331, "KP_DIVIDE", "Num /"},
                           {332, "KP_MULTIPLY", "Num *"},
                           {333, "KP_SUBTRACT", "Num -"},
                           {334, "KP_ADD", "Num +"},
                           {335, "KP_ENTER", "Num Enter"},
                           {336, "KP_EQUAL", "Num ="},
                           {340, "LEFT_SHIFT", "L Shift"},
                           {341, "LEFT_CONTROL", "L Ctrl"},
                           {342, "LEFT_ALT", "L Alt"},
                           {343, "LEFT_SUPER", "L Super"},
                           {344, "RIGHT_SHIFT", "R Shift"},
                           {345, "RIGHT_CONTROL", "R Ctrl"},
                           {346, "RIGHT_ALT", "R Alt"},
                           {347, "RIGHT_SUPER", "R Super"},
                           {348, "MENU", "Menu"}};

constexpr std::array<Named, pad::kButtons> kButtons = {{{pad::kA, "A", "(A)"},
                                                        {pad::kB, "B", "(B)"},
                                                        {pad::kX, "X", "(X)"},
                                                        {pad::kY, "Y", "(Y)"},
                                                        {pad::kLeftBumper, "LEFT_BUMPER", "(LB)"},
                                                        {pad::kRightBumper, "RIGHT_BUMPER", "(RB)"},
                                                        {pad::kBack, "BACK", "(Back)"},
                                                        {pad::kStart, "START", "(Start)"},
                                                        {pad::kGuide, "GUIDE", "(Guide)"},
                                                        {pad::kLeftThumb, "LEFT_THUMB", "(LS)"},
                                                        {pad::kRightThumb, "RIGHT_THUMB", "(RS)"},
                                                        {pad::kUp, "DPAD_UP", "(\u2191)"},
                                                        {pad::kRight, "DPAD_RIGHT", "(\u2192)"},
                                                        {pad::kDown, "DPAD_DOWN", "(\u2193)"},
                                                        {pad::kLeft, "DPAD_LEFT", "(\u2190)"}}};

struct NamedAxis {
  const char* name;
  const char* negative;  // label; null: at rest it is at its lower end
  const char* positive;
};

constexpr std::array<NamedAxis, pad::kAxes> kAxes = {{{"LEFT_X", "(LS\u2190)", "(LS\u2192)"},
                                                      {"LEFT_Y", "(LS\u2191)", "(LS\u2193)"},
                                                      {"RIGHT_X", "(RS\u2190)", "(RS\u2192)"},
                                                      {"RIGHT_Y", "(RS\u2191)", "(RS\u2193)"},
                                                      {"LEFT_TRIGGER", nullptr, "(LT)"},
                                                      {"RIGHT_TRIGGER", nullptr, "(RT)"}}};

constexpr std::string_view kButtonPrefix = "GAMEPAD_BUTTON_", kAxisPrefix = "GAMEPAD_AXIS_";

bool isLetterOrDigit(int code) { return (code >= 'A' && code <= 'Z') || (code >= '0' && code <= '9'); }

std::string keyText(int code, bool label) {
  for (const Named& named : kKeys) {
    if (named.code == code) return label ? named.label : named.name;
  }
  if (isLetterOrDigit(code)) return std::string(1, static_cast<char>(code));
  if (code >= key::kF1 && code <= key::kF25) return "F" + std::to_string(code - key::kF1 + 1);
  if (code >= key::kKeypad0 && code <= key::kKeypad9) {
    return (label ? "Num " : "KP_") + std::to_string(code - key::kKeypad0);
  }
  return {};
}

std::optional<int> keyNamed(std::string_view name) {
  for (int code = key::kSpace; code <= key::kLast; ++code) {
    if (keyText(code, false) == name) return code;
  }
  return std::nullopt;
}

bool isWithin(int code, int count) { return code >= 0 && code < count; }

}  // namespace

std::string inputName(InputCode input) {
  const auto index = static_cast<std::size_t>(input.code);
  switch (input.device) {
    case InputCode::Device::key:
      return keyText(input.code, false);
    case InputCode::Device::button:
      return isWithin(input.code, pad::kButtons) ? std::string(kButtonPrefix) + kButtons[index].name : "";
    case InputCode::Device::axisPositive:
      return isWithin(input.code, pad::kAxes) ? std::string(kAxisPrefix) + kAxes[index].name + "+" : "";
    case InputCode::Device::axisNegative:
      if (!isWithin(input.code, pad::kAxes) || !kAxes[index].negative) return "";
      return std::string(kAxisPrefix) + kAxes[index].name + "-";
  }
  return "";
}

std::optional<InputCode> inputNamed(std::string_view name) {
  if (name.empty()) return std::nullopt;
  for (int code = 0; code < pad::kButtons; ++code) {
    if (inputName(buttonInput(code)) == name) return buttonInput(code);
  }
  for (int code = 0; code < pad::kAxes; ++code) {
    for (const bool positive : {true, false}) {
      if (inputName(axisInput(code, positive)) == name) return axisInput(code, positive);
    }
  }
  if (const auto code = keyNamed(name)) return keyInput(*code);
  return std::nullopt;
}

std::string inputLabel(InputCode input, const KeyLabels& keys) {
  const auto index = static_cast<std::size_t>(input.code);
  if (inputName(input).empty()) return "key " + std::to_string(input.code);
  switch (input.device) {
    case InputCode::Device::key: {
      const auto own = keys.find(input.code);
      return own != keys.end() ? own->second : keyText(input.code, true);
    }
    case InputCode::Device::button:
      return kButtons[index].label;
    case InputCode::Device::axisPositive:
      return kAxes[index].positive;
    case InputCode::Device::axisNegative:
      return kAxes[index].negative;
  }
  return "";
}

}  // namespace skydrop::app
