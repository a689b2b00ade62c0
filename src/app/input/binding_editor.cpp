#include "app/input/binding_editor.h"

#include <utility>

namespace skydrop::app {
namespace {

using render::gl::WindowEvent;

Action actionOfRow(std::size_t row) { return static_cast<Action>(row); }

std::string quoted(Action action) { return "'" + std::string(actionMeaning(action)) + "'"; }

}  // namespace

void BindingEditor::report(const Bindings::Change& change, const std::string& done) {
  if (!change) {
    note_ = "Nothing changed: " + change.refusal + ".";
    return;
  }
  changed_ = true;
  note_ = done;
  for (const Action from : change.takenFrom) {
    note_ += (from == change.takenFrom.front() ? ", taken from " : " and ") + quoted(from);
    if (bindings_.inputsOf(from).empty()) note_ += ", which has nothing left";
  }
  note_ += ".";
}

void BindingEditor::apply(const ui::BindingRequest& request) {
  using Kind = ui::BindingRequest::Kind;
  if (request.kind == Kind::none) return;
  waiting_.reset();
  const Action action = actionOfRow(request.at.row);
  switch (request.kind) {
    case Kind::capture:
      waiting_ = request.at;
      break;
    case Kind::remove: {
      const std::string label = inputLabel(bindings_.inputsOf(action).at(request.at.slot));
      report(bindings_.unbind(action, request.at.slot), label + " no longer does " + quoted(action));
      break;
    }
    case Kind::reset:
      report(bindings_.resetAction(action), quoted(action) + " is as it was at first");
      break;
    case Kind::resetAll:
      bindings_.resetAll();
      report({}, "All controls are as they were at first");
      break;
    case Kind::none:
    case Kind::cancel:
      break;
  }
}

bool BindingEditor::offer(const WindowEvent& event) {
  if (event.kind == WindowEvent::Kind::focus && !event.pressed) cancel();
  if (!waiting_ || event.kind != WindowEvent::Kind::key || !event.pressed || event.repeated) return false;
  if (event.code == key::kEscape) {
    cancel();
  } else {
    offer(keyInput(event.code));
  }
  return true;
}

void BindingEditor::offer(InputCode input) {
  if (!waiting_) return;
  const ui::BindingSlot at = *std::exchange(waiting_, std::nullopt);
  const Action action = actionOfRow(at.row);
  report(bindings_.bind(action, input, at.slot), inputLabel(input) + " now does " + quoted(action));
}

bool BindingEditor::takeChange() { return std::exchange(changed_, false); }

ui::BindingsContent BindingEditor::content(const KeyLabels& keys, const std::string& gamepad) const {
  ui::BindingsContent content{{}, waiting_, note_, gamepad};
  for (std::size_t i = 0; i < kActions; ++i) {
    const Action action = actionOfRow(i);
    ui::BindingRow row{std::string(actionName(action)),
                       std::string(actionMeaning(action)),
                       {},
                       bindings_.isDefault(action),
                       bindings_.inputsOf(action).size() < kMaxInputs};
    for (const InputCode input : bindings_.inputsOf(action)) row.inputs.push_back(inputLabel(input, keys));
    content.rows.push_back(std::move(row));
  }
  return content;
}

}  // namespace skydrop::app
