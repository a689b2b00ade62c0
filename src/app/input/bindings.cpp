#include "app/input/bindings.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "skydrop/core/error.h"

namespace skydrop::app {
namespace {

using Inputs = std::vector<InputCode>;

std::size_t indexOf(Action action) { return static_cast<std::size_t>(action); }

std::array<Inputs, kActions> defaultInputs() {
  std::array<Inputs, kActions> inputs;
  const auto bind = [&inputs](Action action, Inputs of) { inputs[indexOf(action)] = std::move(of); };
  bind(Action::thrust, {keyInput('W'), axisInput(pad::kRightTrigger, true)});
  bind(Action::brake, {keyInput('S'), axisInput(pad::kLeftTrigger, true)});
  bind(Action::rollLeft, {keyInput('A'), keyInput(key::kLeft), axisInput(pad::kLeftX, false)});
  bind(Action::rollRight, {keyInput('D'), keyInput(key::kRight), axisInput(pad::kLeftX, true)});
  bind(Action::noseDown, {keyInput(key::kUp), axisInput(pad::kLeftY, false)});
  bind(Action::noseUp, {keyInput(key::kDown), axisInput(pad::kLeftY, true)});
  bind(Action::yawLeft, {keyInput('Q'), buttonInput(pad::kLeftBumper), axisInput(pad::kRightX, false)});
  bind(Action::yawRight, {keyInput('E'), buttonInput(pad::kRightBumper), axisInput(pad::kRightX, true)});
  bind(Action::drop, {keyInput(key::kSpace), buttonInput(pad::kA)});
  bind(Action::reset, {keyInput('R'), buttonInput(pad::kBack)});
  bind(Action::camera, {keyInput('C'), buttonInput(pad::kY)});
  bind(Action::pause, {keyInput('P'), buttonInput(pad::kX)});
  bind(Action::freeze, {keyInput('F')});
  bind(Action::costs, {keyInput(key::kF2)});
  bind(Action::landingLight, {keyInput('L')});
  bind(Action::ride, {keyInput('V')});
  bind(Action::deliveries, {keyInput('J')});
  bind(Action::weatherBar, {keyInput('B')});
  bind(Action::weatherMode, {keyInput('N')});
  bind(Action::hourBack, {keyInput(',')});
  bind(Action::hourForward, {keyInput('.')});
  bind(Action::timeSlower, {keyInput('[')});
  bind(Action::timeFaster, {keyInput(']')});
  bind(Action::photo, {keyInput('O')});
  bind(Action::split, {keyInput(key::kF3)});
  bind(Action::help, {keyInput('H'), buttonInput(pad::kUp)});
  bind(Action::menu, {keyInput(key::kF1), buttonInput(pad::kRight)});
  bind(Action::mute, {keyInput('M'), buttonInput(pad::kDown)});
  bind(Action::fullScreen, {keyInput(key::kF11)});
  bind(Action::screenshot, {keyInput(key::kF12), buttonInput(pad::kLeft)});
  bind(Action::escape, {keyInput(key::kEscape), buttonInput(pad::kStart)});
  return inputs;
}

struct HelpEntry {
  std::vector<Action> actions;
  std::string meaning;  // empty: the action's own
};

const std::vector<HelpEntry>& helpEntries() {
  static const std::vector<HelpEntry> kEntries = {
      {{Action::thrust, Action::brake}, "faster, slower"},
      {{Action::rollLeft, Action::rollRight}, "roll left, right"},
      {{Action::noseDown, Action::noseUp}, "nose down, up"},
      {{Action::yawLeft, Action::yawRight}, "yaw left, right"},
      {{Action::drop}, ""},
      {{Action::reset}, ""},
      {{Action::camera}, ""},
      {{Action::pause}, ""},
      {{Action::freeze}, ""},
      {{Action::landingLight}, ""},
      {{Action::ride}, ""},
      {{Action::deliveries}, ""},
      {{Action::weatherBar, Action::weatherMode}, "weather bar, live"},
      {{Action::hourBack, Action::hourForward, Action::timeSlower, Action::timeFaster}, "its hour, pace"},
      {{Action::photo}, ""},
      {{Action::costs}, ""},
      {{Action::split}, ""},
      {{Action::help}, "this help"},
      {{Action::menu}, ""},
      {{Action::mute}, ""},
      {{Action::fullScreen}, ""},
      {{Action::screenshot}, ""},
      {{Action::escape}, ""},
  };
  return kEntries;
}

// Reads the inputs, or returns why they cannot be read.
std::string readInputs(const nlohmann::json& names, Inputs& inputs) {
  if (!names.is_array()) return "is no list of names";
  for (const nlohmann::json& name : names) {
    if (!name.is_string()) return name.dump() + " is no name";
    const std::optional<InputCode> input = inputNamed(name.get<std::string>());
    if (!input) return name.dump() + " is no key, button or axis";
    inputs.push_back(*input);
  }
  return inputs.size() > kMaxInputs ? "has more than " + std::to_string(kMaxInputs) + " inputs" : "";
}

}  // namespace

Bindings::Bindings() : inputs_(defaultInputs()) {}

const Inputs& Bindings::inputsOf(Action action) const { return inputs_[indexOf(action)]; }

std::optional<Action> Bindings::actionOf(InputCode input) const {
  for (std::size_t i = 0; i < kActions; ++i) {
    if (std::ranges::find(inputs_[i], input) != inputs_[i].end()) return static_cast<Action>(i);
  }
  return std::nullopt;
}

bool Bindings::isDefault(Action action) const {
  static const std::array<Inputs, kActions> kDefaults = defaultInputs();
  return inputsOf(action) == kDefaults[indexOf(action)];
}

std::string Bindings::refusalOf() const {
  if (actionOf(keyInput(key::kEscape)) != Action::escape) return "Esc always opens the small menu";
  if (std::ranges::none_of(inputsOf(Action::menu), &InputCode::isKey)) {
    return "the configuration menu needs a key";
  }
  return {};
}

Bindings::Change Bindings::assign(Action action, Inputs inputs) {
  Bindings after = *this;
  Change change;
  for (std::size_t i = 0; i < kActions; ++i) {
    if (i == indexOf(action)) continue;
    const auto isTaken = [&](InputCode input) { return std::ranges::find(inputs, input) != inputs.end(); };
    if (std::erase_if(after.inputs_[i], isTaken) > 0) change.takenFrom.push_back(static_cast<Action>(i));
  }
  after.inputs_[indexOf(action)] = std::move(inputs);
  change.refusal = after.refusalOf();
  if (change) {
    *this = std::move(after);
  } else {
    change.takenFrom.clear();
  }
  return change;
}

Bindings::Change Bindings::bind(Action action, InputCode input, std::optional<std::size_t> slot) {
  if (inputName(input).empty()) return {{}, "this key has no name and cannot be kept"};
  Inputs inputs = inputsOf(action);
  if (slot && *slot < inputs.size() && inputs[*slot] == input) return {};
  // Its own input again, at another place: there it goes.
  if (const auto own = std::ranges::find(inputs, input); own != inputs.end()) {
    if (!slot || *slot >= inputs.size()) return {};
    std::swap(*own, inputs[*slot]);
    return assign(action, std::move(inputs));
  }
  if (slot && *slot < inputs.size()) {
    inputs[*slot] = input;
  } else if (inputs.size() < kMaxInputs) {
    inputs.push_back(input);
  } else {
    return {{}, "no room for more than " + std::to_string(kMaxInputs)};
  }
  return assign(action, std::move(inputs));
}

Bindings::Change Bindings::unbind(Action action, std::size_t slot) {
  Inputs inputs = inputsOf(action);
  if (slot < inputs.size()) inputs.erase(inputs.begin() + static_cast<std::ptrdiff_t>(slot));
  return assign(action, std::move(inputs));
}

Bindings::Change Bindings::resetAction(Action action) { return assign(action, Bindings().inputsOf(action)); }

nlohmann::json Bindings::toJson() const {
  nlohmann::json json = nlohmann::json::object();
  for (std::size_t i = 0; i < kActions; ++i) {
    const auto action = static_cast<Action>(i);
    if (isDefault(action)) continue;
    nlohmann::json& names = json[std::string(actionName(action))] = nlohmann::json::array();
    for (const InputCode input : inputsOf(action)) names.push_back(inputName(input));
  }
  return json;
}

Bindings Bindings::changedBy(const std::map<Action, Inputs>& wanted) {
  Bindings bindings;
  std::set<InputCode> named;
  for (const auto& [action, inputs] : wanted) named.insert(inputs.begin(), inputs.end());
  for (std::size_t i = 0; i < kActions; ++i) {
    const auto own = wanted.find(static_cast<Action>(i));
    if (own != wanted.end()) {
      bindings.inputs_[i] = own->second;
    } else {
      std::erase_if(bindings.inputs_[i], [&](InputCode input) { return named.contains(input); });
    }
  }
  return bindings;
}

Bindings::Read Bindings::fromJson(const nlohmann::json& json) {
  Read read;
  const auto complain = [&](const std::string& place, const std::string& reason) {
    read.complaints.push_back(place + ": " + reason);
  };
  if (!json.is_object()) {
    complain("bindings", "is no object");
    return read;
  }
  std::set<InputCode> named;
  for (const auto& [name, names] : json.items()) {
    const std::string place = "bindings." + name;
    const std::optional<Action> action = actionNamed(name);
    Inputs inputs;
    std::string reason = action ? readInputs(names, inputs) : "is no action";
    std::set<InputCode> taken = named;
    for (const InputCode input : inputs) {
      if (reason.empty() && !taken.insert(input).second) reason = inputName(input) + " is bound twice";
    }
    if (reason.empty()) {
      named = std::move(taken);
      read.used.emplace(*action, std::move(inputs));
    } else {
      complain(place, reason);
    }
  }
  // A rule is broken by one entry, or, rarely, by several together: then none of them counts.
  for (std::string refusal; !(refusal = changedBy(read.used).refusalOf()).empty();) {
    const auto mended = [&](const auto& entry) {
      std::map<Action, Inputs> others = read.used;
      others.erase(entry.first);
      return changedBy(others).refusalOf().empty();
    };
    const auto culprit = std::ranges::find_if(read.used, mended);
    if (culprit == read.used.end()) {
      complain("bindings", refusal);
      read.used.clear();
    } else {
      complain("bindings." + std::string(actionName(culprit->first)), refusal);
      read.used.erase(culprit);
    }
  }
  read.bindings = changedBy(read.used);
  return read;
}

std::vector<ui::HelpRow> helpRows(const Bindings& bindings, bool gamepad, const KeyLabels& keys) {
  std::vector<ui::HelpRow> rows;
  for (const HelpEntry& entry : helpEntries()) {
    // First inputs first: "A D  arrows", not "A arrow D arrow"; those of the gamepad after the keys.
    std::string labels;
    for (const bool ofGamepad : {false, true}) {
      if (ofGamepad && !gamepad) continue;
      for (std::size_t i = 0; i < kMaxInputs; ++i) {
        for (const Action action : entry.actions) {
          Inputs inputs = bindings.inputsOf(action);
          std::erase_if(inputs, [&](InputCode input) { return input.isKey() == ofGamepad; });
          if (i < inputs.size()) labels += (labels.empty() ? "" : " ") + inputLabel(inputs[i], keys);
        }
      }
    }
    if (labels.empty()) continue;
    rows.push_back(
        {labels, entry.meaning.empty() ? std::string(actionMeaning(entry.actions.front())) : entry.meaning});
  }
  return rows;
}

}  // namespace skydrop::app
