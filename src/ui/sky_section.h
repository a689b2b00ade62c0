// What the sections of sky and sun have above their rows: moods as buttons, and the clock to be turned.
#pragma once

#include <optional>

#include "skydrop/core/settings_table.h"
#include "ui/menu_item.h"

namespace skydrop::ui {

// A button for each name of a choice but the first, the chosen one lit; clicking that again takes the first.
// Returns what was clicked. Places: "mood NAME".
std::optional<double> drawChoiceButtons(const core::Field& choice, ItemPlaces& places);

struct ClockRequest {
  double turnedMs = 0;          // by how much the clock is to show another time
  std::optional<double> speed;  // how fast it is to run
  bool held = false;            // the slider is held: what follows is the same step
};

// The time of day as a slider, steps of 10 minutes, an hour and a day, and speeds. nowMs: what the clock
// shows (UTC, ms since 1970); speed: how fast it runs. Places: "clock", "clock +1 h" ..., "speed 60" ...
ClockRequest drawClock(double nowMs, double speed, const core::WrittenForm& form, ItemPlaces& places);

}  // namespace skydrop::ui
