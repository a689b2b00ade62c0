// The menus. The configuration menu is generated from the described settings: a row per field, no row written
// by hand. Both return plain data; what follows from a change or an action is the caller's business. Drawn
// between Interface::beginFrame and endFrame. Main thread.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "skydrop/core/frame_statistics.h"
#include "skydrop/core/settings_table.h"
#include "skydrop/ui/imgui_context.h"

namespace skydrop::ui {

// A collapsing section with the fields of one group of the table, its subgroups included.
struct MenuSection {
  std::string group;  // path in the table: "aircraft"
  std::string title;  // "Aircraft"
  bool open = false;  // at first
};

struct MenuContent {
  const core::SettingsTable& table;  // edited
  std::span<const MenuSection> sections;
  const core::FrameStatistics* statistics =
      nullptr;             // shown as what accuracy costs in time; null: no section
  std::string_view error;  // of the last reload; empty: none
};

struct MenuResult {
  bool closed = false;                    // the cross was clicked
  std::vector<std::string> changedPaths;  // set in this frame, each once
};

// Rows of one frame: where the mouse finds them.
struct MenuRowPlace {
  ScreenRect value;
  std::optional<ScreenRect> reset;  // shown while the value is not the default
};

class ConfigurationMenu {
 public:
  // Live fields are set while a slider moves; fields that take effect by a variant, a rebuild or a restart
  // when it is released. Values typed (Ctrl and a click on a slider) are clamped to the range.
  MenuResult draw(const Interface& context, const MenuContent& content);

  // Rows drawn in the last frame, by path; rows scrolled out of sight included.
  const std::map<std::string, MenuRowPlace>& places() const { return places_; }
  const ScreenRect& resetAllPlace() const { return resetAllPlace_; }
  // The whole window in the last frame that drew it, and the cross in its title bar.
  const ScreenRect& place() const { return place_; }
  ScreenRect crossPlace() const;

 private:
  void drawRow(const core::Field& field, MenuResult& result);
  bool editValue(const core::Field& field, double& value);
  void commit(const core::Field& field, double value, MenuResult& result);

  struct PendingEdit {
    std::string path;
    double value;
  };
  std::optional<PendingEdit> pending_;  // of a slider that is held
  std::map<std::string, MenuRowPlace> places_;
  ScreenRect place_, resetAllPlace_;
  float titleHeight_ = 0;
  int placedWidth_ = 0, placedHeight_ = 0;  // the window size that the menu was last placed in
};

enum class EscapeAction { none, resume, help, quit };

// The small menu on Escape: by mouse, or up, down and Enter. Opening and closing it on Escape is the
// caller's.
class EscapeMenu {
 public:
  // Selects the first entry again.
  void reset() { selected_ = 0; }
  EscapeAction draw(const Interface& context);

  int selected() const { return selected_; }
  // Where the entries were drawn in the last frame: resume, help, quit.
  std::span<const ScreenRect> places() const { return places_; }

 private:
  int selected_ = 0;
  std::vector<ScreenRect> places_;
};

}  // namespace skydrop::ui
