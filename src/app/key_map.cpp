#include "app/key_map.h"

#include <algorithm>

namespace skydrop::app {
namespace {

struct HelpEntry {
  std::vector<Action> actions;
  const char* meaning;
};

const std::vector<HelpEntry>& helpEntries() {
  static const std::vector<HelpEntry> kEntries = {
      {{Action::thrust, Action::brake}, "faster, slower"},
      {{Action::rollLeft, Action::rollRight}, "roll left, right"},
      {{Action::noseDown, Action::noseUp}, "nose down, up"},
      {{Action::yawLeft, Action::yawRight}, "yaw left, right"},
      {{Action::drop}, "drop a package"},
      {{Action::reset}, "back to the start"},
      {{Action::camera}, "camera"},
      {{Action::pause}, "pause"},
      {{Action::freeze}, "freeze time"},
      {{Action::help}, "this help"},
      {{Action::menu}, "configuration"},
      {{Action::mute}, "sound on, off"},
      {{Action::fullScreen}, "full screen"},
      {{Action::screenshot}, "screenshot"},
      {{Action::escape}, "resume, quit"},
  };
  return kEntries;
}

}  // namespace

bool isFlightAction(Action action) { return action <= Action::reset; }

std::optional<Action> KeyMap::actionOf(int keyCode) const {
  for (const KeyBinding& binding : bindings_) {
    if (std::ranges::find(binding.keys, keyCode) != binding.keys.end()) return binding.action;
  }
  return std::nullopt;
}

KeyMap defaultKeyMap() {
  return KeyMap({{Action::thrust, {'W'}},
                 {Action::brake, {'S'}},
                 {Action::rollLeft, {'A', key::kLeft}},
                 {Action::rollRight, {'D', key::kRight}},
                 {Action::noseDown, {key::kUp}},
                 {Action::noseUp, {key::kDown}},
                 {Action::yawLeft, {'Q'}},
                 {Action::yawRight, {'E'}},
                 {Action::drop, {key::kSpace}},
                 {Action::reset, {'R'}},
                 {Action::camera, {'C'}},
                 {Action::pause, {'P'}},
                 {Action::freeze, {'F'}},
                 {Action::help, {'H'}},
                 {Action::menu, {key::kF1}},
                 {Action::mute, {'M'}},
                 {Action::fullScreen, {key::kF11}},
                 {Action::screenshot, {key::kF12}},
                 {Action::escape, {key::kEscape}}});
}

std::string keyName(int keyCode) {
  switch (keyCode) {
    case key::kSpace:
      return "Space";
    case key::kEscape:
      return "Esc";
    case key::kEnter:
      return "Enter";
    case key::kTab:
      return "Tab";
    case key::kLeft:
      return "\u2190";
    case key::kRight:
      return "\u2192";
    case key::kUp:
      return "\u2191";
    case key::kDown:
      return "\u2193";
    default:
      break;
  }
  if (keyCode >= key::kF1 && keyCode <= key::kF25) return "F" + std::to_string(keyCode - key::kF1 + 1);
  if (keyCode > key::kSpace && keyCode < 127) return std::string(1, static_cast<char>(keyCode));
  return "key " + std::to_string(keyCode);
}

std::vector<ui::HelpRow> helpRows(const KeyMap& map) {
  std::vector<ui::HelpRow> rows;
  for (const HelpEntry& entry : helpEntries()) {
    // First keys first: "A D  arrows", not "A arrow D arrow".
    std::string keys;
    for (std::size_t i = 0;; ++i) {
      bool found = false;
      for (const Action action : entry.actions) {
        for (const KeyBinding& binding : map.bindings()) {
          if (binding.action != action || i >= binding.keys.size()) continue;
          keys += (keys.empty() ? "" : " ") + keyName(binding.keys[i]);
          found = true;
        }
      }
      if (!found) break;
    }
    if (!keys.empty()) rows.push_back({keys, entry.meaning});
  }
  return rows;
}

}  // namespace skydrop::app
