// The menus. The configuration menu is generated from the described settings: a row per field, no row written
// by hand. Both return plain data; what follows from a change or an action is the caller's business. Drawn
// between Interface::beginFrame and endFrame. Main thread.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "skydrop/core/frame_statistics.h"
#include "skydrop/core/settings_table.h"
#include "skydrop/ui/bindings_view.h"
#include "skydrop/ui/imgui_context.h"
#include "skydrop/ui/undo_history.h"

namespace skydrop::ui {

// A collapsing section with the fields of one group of the table, its subgroups included but for those that
// have a section of their own. That of the group "effects" has switches with what each effect costs.
struct MenuSection {
  std::string group;                         // path in the table: "aircraft"; names the section
  std::string title;                         // "Aircraft"
  bool open = false;                         // at first
  std::vector<std::string> moreGroups = {};  // shown below it
  // What it has above its rows: buttons for the choice that is its group's first row, the clock of the sky
  // (MenuTools::clockMs), or such buttons and a picture for each genus of clouds (MenuTools::genera).
  enum class Head { none, choiceButtons, clock, weather };
  Head head = Head::none;
};

// The section that shows the field; null: none.
const MenuSection* sectionOf(std::span<const MenuSection> sections, const core::Field& field);

// A preset as the menu lists it.
struct PresetEntry {
  std::string name;
  std::string holds;  // which groups, in words; of a broken one why it cannot be used
  bool usable = true;
};

// A picture to click: a genus of clouds, and the rows that make it. It is lit while all have these values;
// clicked then, it takes its clouds away.
struct GenusButton {
  std::string_view name;             // "cumulus": what is drawn on it
  std::vector<SettingValue> values;  // of rows of the table
  std::vector<SettingValue> away;    // the same without the clouds
};

// What the menu shows beside the settings.
struct MenuTools {
  std::span<const double> frameMs = {};  // times of the last frames, the newest last
  // What a run without flags may start from: flags are copied for what differs from one of them.
  std::span<const core::SettingsTable* const> bases = {};
  std::string_view pose = {};  // of the present view, "--pose=..."; empty: none
  // The player's presets; nullopt where they have no place.
  std::optional<std::span<const PresetEntry>> presets = std::nullopt;
  std::optional<double> clockMs = std::nullopt;  // what the sky's clock shows, UTC, ms since 1970
  std::span<const GenusButton> genera = {};
};

struct MenuContent {
  const core::SettingsTable& table;  // edited
  std::span<const MenuSection> sections;
  const core::FrameStatistics* statistics =
      nullptr;                  // shown as what accuracy costs in time; null: no section
  std::string_view error = {};  // what is broken now (app/window/faults.h); empty: nothing is
  MenuTools tools = {};
  const BindingsContent* bindings = nullptr;  // null: no section
};

struct PresetRequest {
  enum class Kind { save, load, remove };
  Kind kind = Kind::save;
  std::string name;                      // save: as typed, to be judged by the caller
  std::vector<std::string> groups = {};  // save: what it holds, a section's groups; empty: every setting
};

struct MenuResult {
  bool closed = false;                    // the cross was clicked
  std::vector<std::string> changedPaths;  // set in this frame, each once
  std::optional<PresetRequest> preset;
  BindingRequest binding;
};

// Rows of one frame: where the mouse finds them.
struct MenuRowPlace {
  ScreenRect value;
  std::optional<ScreenRect> reset;  // shown while the value is not the default
};

// What the menu remembers between flights.
struct MenuState {
  std::optional<ScreenRect>
      place;  // as shares of the window's width and height; nullopt: beside the aircraft
  std::map<std::string, bool> open;  // sections by group; one that is not named is as its MenuSection says
};

class ConfigurationMenu {
 public:
  ConfigurationMenu();
  ~ConfigurationMenu();
  ConfigurationMenu(const ConfigurationMenu&) = delete;
  ConfigurationMenu& operator=(const ConfigurationMenu&) = delete;

  // Live fields are set while a slider moves; fields that take effect by a variant, a rebuild or a restart
  // when it is released. A value that is typed (Ctrl and a click, a double click, or the right button, on a
  // slider; or PATH=VALUE and Enter in the search field) is taken as it stands or refused with a line. Every
  // change can be undone; a drag is one step.
  MenuResult draw(const Interface& context, const MenuContent& content);

  // Sets values from outside (a preset) as one step that can be undone. Returns the paths that changed.
  // Unknown paths and values out of range throw core::RangeError; then nothing has changed.
  std::vector<std::string> change(const core::SettingsTable& table, std::span<const SettingValue> values);

  // What was changed last, here or by change(), could not be carried out: it leaves no step to undo. Sets
  // nothing.
  void takeBack();

  const MenuState& state() const;
  void setState(MenuState state);

  // Whether the costs or the effects with their bill are open: then somebody looks at the times.
  bool showsCosts() const;

  // Rows drawn in the last frame, by path; rows scrolled out of sight included.
  const std::map<std::string, MenuRowPlace>& places() const;
  const BindingsPlaces& bindingPlaces() const;
  // Where the last frame drew what is no row: "refusal" (while there is a line), "search", "changed only",
  // "undo", "redo", "reset all", "section GROUP", "reset GROUP", "controls", "costs", "presets", "preset
  // name", "save preset", "load NAME", "delete NAME", "mood NAME", "genus NAME", "clock",
  // "clock +1 h" (and the other steps), "speed 60" (and the others), "copy", "copy flags", "copy pose". Null:
  // not drawn.
  const ScreenRect* place(std::string_view what) const;
  // The whole window in the last frame that drew it, and the cross in its title bar.
  const ScreenRect& place() const;
  ScreenRect crossPlace() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

enum class EscapeAction { none, resume, help, laboratory, quit };

// The small menu on Escape: by mouse, or up, down and Enter. Opening and closing it on Escape is the
// caller's.
class EscapeMenu {
 public:
  // Selects the first entry again.
  void reset() { selected_ = 0; }
  EscapeAction draw(const Interface& context);

  int selected() const { return selected_; }
  // Where the entries were drawn in the last frame: resume, help, laboratory, quit.
  std::span<const ScreenRect> places() const { return places_; }

 private:
  int selected_ = 0;
  std::vector<ScreenRect> places_;
};

}  // namespace skydrop::ui
