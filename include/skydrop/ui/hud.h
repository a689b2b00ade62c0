// The head-up display: what the pilot reads while flying. makeHudData picks it out of a snapshot (pure),
// layoutHud places it (pure, for a window size), drawHud draws the layout. Nothing here depends on time
// except through HudData, so a frame shows the same whenever it is drawn. Main thread.
//
// The navigation bar is north-up, like the thesis's: the top of the circle is north (-z), its right is east
// (+x), whatever the aircraft's heading. The black arrow is then the velocity as a map shows it, and it
// points at the blue dot when the aircraft flies to the target.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "skydrop/game/snapshot.h"
#include "skydrop/ui/hud_marks.h"
#include "skydrop/ui/imgui_context.h"
#include "skydrop/ui/instruments.h"

namespace skydrop::ui {

// Distance at which the dot leaves the rim of the circle and begins to move inwards.
inline constexpr double kNavigationRangeM = 2000;
// Speed that an arrow from the centre to the rim stands for: the aircraft's top speed.
inline constexpr double kNavigationSpeedMps = 120;
// How long a flight shows which key helps.
inline constexpr double kHintSeconds = 10;
// The dot is lit for the first part of each period of simulated time.
inline constexpr double kBlinkPeriodSeconds = 1.0, kBlinkLitSeconds = 0.6;
// The drop text swells and fades once a period of simulated time.
inline constexpr double kPulsePeriodSeconds = 0.8;

// Map coordinates of the circle: x to the right (east), y down (south); the rim has length 1.
struct NavigationBar {
  std::optional<glm::dvec2> arrow;  // none below 0.5 m/s over the ground
  std::optional<glm::dvec2> dot;    // none without a target; (0, 0) straight above it
  bool dotLit = false;
};

struct HudMessage {
  std::string text;
  double opacity = 1;  // falls to 0 in the last half second
};

// What stands on the keys that the display names; empty: none does it.
struct HudKeys {
  std::string drop = "Space", pause = "P", help = "H", reset = "R";
};

// Of the newest package in the air.
struct HudPackage {
  double seconds = 0;           // until it lands
  std::optional<double> missM;  // from the centre of its target; none without one
  bool hits = false;
};

// A table in the middle, in place of what else is there.
struct HudPanel {
  std::string title;
  std::vector<std::vector<std::string>> rows;  // of cells
  std::string footer;
};

// In scenes with weather: what the air does to the flight.
struct HudAir {
  double indicatedMps = 0, groundMps = 0;
  double crabDeg = 0;  // by which the nose points right of the path over the ground
  double windMps = 0, windFromDeg = 0;
  double icing = 0;  // 0..1
};

struct HudData {
  HudKeys keys;
  bool aircraft = false;  // without one: score, messages and notes alone
  double airspeedMps = 0;
  double altitudeM = 0;           // above the sea
  double heightAboveGroundM = 0;  // above land or sea
  double headingDeg = 0;          // compass, [0, 360)
  double throttle = 0;            // 0..1
  std::optional<double> targetDistanceM;
  std::optional<HudAir> air;
  NavigationBar navigation;
  std::int64_t score = 0, misses = 0;
  std::optional<double> dropPulse;   // 0..1 while a package dropped now would hit
  double cooldownSeconds = 0;        // until the next drop
  std::vector<HudMessage> messages;  // newest last, at most three
  bool stallWarning = false;         // near the stall: not yet in it
  bool stalled = false;
  std::optional<double> respawnSeconds;  // after a crash
  double hintOpacity = 0;  // of the line that names the help: in the first seconds, without autopilot
  bool paused = false;
  bool autopilot = false;
  bool frozen = false;
  std::string ground;  // what the wheels do: empty in the air
  std::int64_t points = 0;
  std::optional<HudPackage> package;
  bool pullUp = false;                            // ground ahead
  std::string crashReason;                        // after a crash
  std::optional<InstrumentReadings> instruments;  // the dials; none: they are not shown
  std::vector<HudMark> marks;
  std::optional<HudPanel> panel;
  double pictureAspect = 0;  // of the picture of the package at the upper right; 0: there is none
};

// Values that are not finite are shown as 0.
HudData makeHudData(const game::Snapshot& snapshot);

// One row of the help overlay.
struct HelpRow {
  std::string keys;
  std::string meaning;
};

struct HudText {
  std::string text;
  glm::vec2 position{0};  // top left, pixels
  enum class Tone { normal, dim, accent, warning } tone = Tone::normal;
  bool large = false;
  double opacity = 1;
};

// A piece of the display that no other piece may cover.
struct HudItem {
  std::string name;  // "flight", "navigation", "drop" ...
  ScreenRect rect;
  double plateOpacity = 0;  // of the dark plate behind it
  std::vector<HudText> texts;
};

struct HudLayout {
  std::vector<HudItem> items;
  ScreenRect throttleBar;     // inside the item "flight"; empty without an aircraft
  glm::vec2 circleCentre{0};  // of the navigation bar
  float circleRadius = 0;     // 0 without an aircraft
  std::optional<std::array<ScreenRect, kInstruments>> instruments;  // none where they have no room
  ScreenRect picture;                                               // of the package; empty: there is none
};

// `help` empty: the overlay is closed. `menu`: where the configuration menu stands; what belongs in the
// middle moves to the wider side of it, and is left out where that is too narrow. `taken`: pixels at the
// bottom that belong to something else. Items keep inside the window and apart from each other from 320 x 180
// pixels on; texts too long for their place are cut with an ellipsis. Needs the Interface's fonts, no frame.
HudLayout layoutHud(const Interface& context, const HudData& data, std::span<const HelpRow> help = {},
                    const std::optional<ScreenRect>& menu = std::nullopt, float taken = 0);

// Between beginFrame and endFrame; under all menus.
void drawHud(const Interface& context, const HudData& data, const HudLayout& layout);

}  // namespace skydrop::ui
