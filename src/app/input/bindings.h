// Which key, button or stick does what, as the player wants it: defaults, changes with their rules, and the
// JSON object in which the changes are kept. A value; main thread.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/input/action.h"
#include "app/input/input_code.h"
#include "skydrop/ui/hud.h"

namespace skydrop::app {

// As many as a row of the menu shows.
inline constexpr std::size_t kMaxInputs = 4;

// Two rules hold at all times. An input belongs to one binding at most. And the player always gets back:
// Escape opens the small menu and does nothing else, and the configuration menu has at least one key.
class Bindings {
 public:
  // Keyboard: W S, A D and the arrows, Q E, space, and the rest. Gamepad: left stick, triggers, bumpers or
  // right stick, and the rest. docs/menu-and-hud.md lists them.
  Bindings();

  const std::vector<InputCode>& inputsOf(Action action) const;
  std::optional<Action> actionOf(InputCode input) const;
  bool isDefault(Action action) const;

  // What a change did: the others it took inputs from, or why it did nothing.
  struct Change {
    std::vector<Action> takenFrom;
    std::string refusal;  // one line; empty: done

    explicit operator bool() const { return refusal.empty(); }
  };

  // Adds the input to the action, or puts it in the place of the input at `slot`. Taken from whatever had it.
  Change bind(Action action, InputCode input, std::optional<std::size_t> slot = std::nullopt);
  Change unbind(Action action, std::size_t slot);
  // Back to the defaults, which are taken from whatever has them now.
  Change resetAction(Action action);
  // Exactly these inputs.
  Change assign(Action action, std::vector<InputCode> inputs);
  void resetAll() { *this = Bindings(); }

  // {"rollLeft": ["A", "GAMEPAD_AXIS_LEFT_X-"], ...}: the actions that are not at their defaults.
  nlohmann::json toJson() const;
  // Defaults, changed by such an object. What the object names keeps its inputs; a default that it gives to
  // another action is taken from its own. What does not fit is left out and complained of.
  struct Read;
  static Read fromJson(const nlohmann::json& json);

  bool operator==(const Bindings&) const = default;

 private:
  std::string refusalOf() const;  // why these bindings would break a rule
  static Bindings changedBy(const std::map<Action, std::vector<InputCode>>& wanted);

  std::array<std::vector<InputCode>, kActions> inputs_;
};

struct Bindings::Read {
  Bindings bindings;
  std::map<Action, std::vector<InputCode>> used;  // what the object asked for and got
  std::vector<std::string> complaints;            // "bindings.fly: is no action"
};

// The rows of the help overlay; opposite actions share one. Inputs of a gamepad only where one is there.
std::vector<ui::HelpRow> helpRows(const Bindings& bindings, bool gamepad = false, const KeyLabels& keys = {});

}  // namespace skydrop::app
