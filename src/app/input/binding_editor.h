// Changes of the bindings while flying: waits for the key, button or stick that the player gives to an
// action, and says what became of it. Main thread.
#pragma once

#include <optional>
#include <string>

#include "app/input/bindings.h"
#include "skydrop/render/platform/window_context.h"
#include "skydrop/ui/bindings_view.h"

namespace skydrop::app {

class BindingEditor {
 public:
  explicit BindingEditor(Bindings& bindings) : bindings_(bindings) {}

  // What the menu asks for.
  void apply(const ui::BindingRequest& request);
  bool isWaiting() const { return waiting_.has_value(); }
  void cancel() { waiting_.reset(); }

  // While waiting the next key is bound; Escape cancels, as does losing the focus. True: the event was taken,
  // and is nobody else's.
  bool offer(const render::gl::WindowEvent& event);
  // The same for what was pressed or pushed on a gamepad.
  void offer(InputCode input);

  // True once after bindings changed.
  bool takeChange();

  ui::BindingsContent content(const KeyLabels& keys, const std::string& gamepad) const;

 private:
  void report(const Bindings::Change& change, const std::string& done);

  Bindings& bindings_;
  std::optional<ui::BindingSlot> waiting_;
  std::string note_;
  bool changed_ = false;
};

}  // namespace skydrop::app
