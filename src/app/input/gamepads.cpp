#include "app/input/gamepads.h"

#include <algorithm>
#include <utility>

namespace skydrop::app {

void Gamepads::look() {
  const std::vector<Joystick> all = source_.list();
  for (const Joystick& joystick : all) {
    if (joystick.isMapped || !unmapped_.insert(joystick.name).second) continue;
    messages_.push_back({"Joystick '" + joystick.name + "' has no gamepad mapping and is not used"});
  }
  const auto used = std::ranges::find_if(all, &Joystick::isMapped);
  const std::optional<int> id = used == all.end() ? std::nullopt : std::optional(used->id);
  const std::string name = id ? used->name : std::string();
  if (id_ && (id != id_ || name != name_)) messages_.push_back({"Gamepad '" + name_ + "' is gone"});
  if (id && (id != id_ || name != name_)) messages_.push_back({"Gamepad '" + name + "'"});
  if (!looked_ && !id) messages_.push_back({"no gamepad: the keyboard flies", false});
  looked_ = true;
  id_ = id;
  name_ = name;
}

std::optional<GamepadState> Gamepads::poll() {
  if (source_.takeChange()) look();
  return id_ ? source_.read(*id_) : std::nullopt;
}

std::vector<GamepadMessage> Gamepads::takeMessages() { return std::exchange(messages_, {}); }

}  // namespace skydrop::app
