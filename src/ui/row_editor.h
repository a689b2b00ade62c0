// The widget of one setting: a slider, box or list, or the text field that replaces it while a value
// is typed. Says what the user did; sets nothing itself. Between Interface::beginFrame and endFrame.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "skydrop/core/settings_table.h"
#include "skydrop/ui/imgui_context.h"

namespace skydrop::ui {

struct RowOutcome {
  std::optional<double> value;       // to be set; of a slider: within its part of the range
  std::optional<std::string> typed;  // to be set if it can be
  bool held = false;                 // more of the same change may follow
  // A text field is asked for. The first click of a double click has moved the slider: `before` was there
  // until then.
  bool wantsToType = false;
  std::optional<double> before;
  int nextRow = 0;  // Tab: type on in the next (1) or the previous row (-1)
};

class RowEditor {
 public:
  // Fills the width that is left. `place` is where the widget stands.
  RowOutcome draw(const core::Field& field, ScreenRect& place);

  // From the next frame on a text field with the field's present value replaces it. Numbers only.
  void type(const core::Field& field);
  static bool isTyped(const core::Field& field);

 private:
  struct Pending {
    double value;
    std::optional<double> releasedAt;  // seconds
  };
  struct Typing {
    std::string path, first;  // what stood in the field at first
    char text[64] = {};
    int framesToFocus;
  };
  struct Press {
    std::string path;
    double before;
  };

  RowOutcome drawTyping(const core::Field& field, ScreenRect& place);
  RowOutcome drawSlider(const core::Field& field, ScreenRect& place);

  std::map<std::string, Pending> pending_;  // of slow settings, by path
  std::optional<Typing> typing_;
  std::optional<Press> press_;  // the last one on a slider
};

}  // namespace skydrop::ui
