// Which key does what. Codes are GLFW's (GLFW/glfw3.h), as plain integers: a test needs no window library.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skydrop/ui/hud.h"

namespace skydrop::app {

enum class Action {
  // held: they fly the aircraft (game::Controls)
  thrust,
  brake,
  rollLeft,
  rollRight,
  noseDown,
  noseUp,
  yawLeft,
  yawRight,
  drop,
  reset,
  // pressed: once a press (PlayerInput::takeActions)
  camera,
  pause,
  help,
  menu,
  mute,
  fullScreen,
  screenshot,
  freeze,
  escape,
};

// Goes into game::Controls; the others are for the program.
bool isFlightAction(Action action);

namespace key {
inline constexpr int kSpace = 32, kEscape = 256, kEnter = 257, kTab = 258, kBackspace = 259, kInsert = 260,
                     kDelete = 261, kRight = 262, kLeft = 263, kDown = 264, kUp = 265, kPageUp = 266,
                     kPageDown = 267, kHome = 268, kEnd = 269, kF1 = 290, kF11 = 300, kF12 = 301, kF25 = 314,
                     kKeypadEnter = 335, kLeftShift = 340, kLeftControl = 341, kLeftAlt = 342,
                     kLeftSuper = 343, kRightShift = 344, kRightControl = 345, kRightAlt = 346,
                     kRightSuper = 347, kLast = 348;
// Letters and digits are their capital ASCII codes.
}  // namespace key

struct KeyBinding {
  Action action;
  std::vector<int> keys;
};

class KeyMap {
 public:
  // A key stands in one binding at most.
  explicit KeyMap(std::vector<KeyBinding> bindings) : bindings_(std::move(bindings)) {}

  std::optional<Action> actionOf(int keyCode) const;
  const std::vector<KeyBinding>& bindings() const { return bindings_; }

 private:
  std::vector<KeyBinding> bindings_;
};

// W S, A D and the arrows, Q E, space, and the rest: docs/menu-and-hud.md.
KeyMap defaultKeyMap();

// "W", "Space", "F11", "\u2190"
std::string keyName(int keyCode);

// The rows of the help overlay; opposite actions share one.
std::vector<ui::HelpRow> helpRows(const KeyMap& map);

}  // namespace skydrop::app
