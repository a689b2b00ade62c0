// The interface of the laboratory: the list of pages and the explanation at the left, the picture beside it,
// the page's knobs below. Says what the user wants; a changed knob is set in the table, all else is the
// caller's business. Drawn between Interface::beginFrame and endFrame. Main thread.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "skydrop/core/settings_table.h"
#include "skydrop/ui/imgui_context.h"

namespace skydrop::ui {

struct LabEntry {
  std::string_view chapter, name, title;  // of one chapter in succession
};

struct LabContent {
  std::span<const LabEntry> entries;
  std::size_t chosen = 0;
  std::string_view text;             // explains the chosen page
  const core::SettingsTable& table;  // its knobs
  std::uint32_t texture = 0;         // its picture, the first row at the bottom; 0: none
  std::string_view figures = {};     // cost and error, columns of one width; may be empty
  std::string_view status = {};      // what a frame took, or what failed
};

struct LabResult {
  std::optional<std::size_t> chosen;
  bool changed = false;             // a knob was set
  bool held = false;                // the mouse holds it: more may follow
  double turnedX = 0, turnedY = 0;  // what the mouse dragged the picture by, lines of text
  double zoomed = 0;                // by the wheel over the picture, notches
  bool reset = false, measure = false;
  std::optional<std::string> refusal;  // why a typed value was not set
};

// The size of the picture in a window of this size, pixels.
struct LabPictureSize {
  int width = 1, height = 1;
};
LabPictureSize labPictureSize(int width, int height, float linePixels);

class LabView {
 public:
  LabView();
  ~LabView();

  LabResult draw(const Interface& context, const LabContent& content);

  // Where the last frame drew a page's entry or a knob (by name or path), a button (by its label) or
  // "picture".
  std::optional<ScreenRect> placeOf(std::string_view name) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

// The knobs that differ from their defaults as words of a command line, after "skydrop lab --page NAME".
std::string knobFlags(const core::SettingsTable& table);

}  // namespace skydrop::ui
