// What the configuration menu shows of the controls: lists what each key, button and stick does and lets it
// be changed. Plain data in, one request out; the rules and the waiting for a key are the caller's
// (app/input/binding_editor.h). Between Interface::beginFrame and endFrame. Main thread.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "skydrop/ui/imgui_context.h"

namespace skydrop::ui {

struct BindingRow {
  std::string name;                 // unique: "rollLeft"
  std::string meaning;              // "roll left"
  std::vector<std::string> inputs;  // labels, "A", "(LS\u2190)"
  bool isDefault = true;
  bool canAdd = true;  // there is room for one more
};

// An input of a row; slot == inputs.size() stands for one that is added.
struct BindingSlot {
  std::size_t row = 0, slot = 0;
  bool operator==(const BindingSlot&) const = default;
};

struct BindingsContent {
  std::vector<BindingRow> rows;
  std::optional<BindingSlot> waiting;  // for a key or a button
  std::string note;                    // what the last change did
  std::string gamepad;                 // its name; empty: none
};

struct BindingRequest {
  enum class Kind { none, capture, cancel, remove, reset, resetAll };
  Kind kind = Kind::none;
  BindingSlot at;  // row alone for reset
};

// Where the last frame drew them, for those who click.
struct BindingsPlaces {
  struct Row {
    std::vector<ScreenRect> inputs;
    std::optional<ScreenRect> add, reset;
  };
  ScreenRect resetAll;
  std::map<std::string, Row> rows;  // by name
};

BindingRequest drawBindings(const BindingsContent& content, BindingsPlaces& places);

}  // namespace skydrop::ui
