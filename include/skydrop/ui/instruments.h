// The instruments of the cockpit, as the display shows them: six dials in a row along the bottom. What a
// needle shows is a pure function of the reading, finite for any: a reading that is not finite counts as 0,
// one beyond the scale rests at its end. Drawing happens between Interface::beginFrame and endFrame. Main
// thread.
#pragma once

#include <array>
#include <cstddef>

#include "skydrop/game/snapshot.h"
#include "skydrop/ui/imgui_context.h"

struct ImDrawList;

namespace skydrop::ui {

struct InstrumentReadings {
  double airspeedMps = 0;  // as instruments show it
  double pitchRad = 0, bankRad = 0;
  double altitudeM = 0;  // above the sea
  double headingRad = 0;
  double climbMps = 0;
  double throttle = 0;  // 0 .. 1
  bool stallWarning = false;
};
InstrumentReadings readingsOf(const game::Snapshot& snapshot);

inline constexpr std::size_t kInstruments = 6;  // airspeed, attitude, altimeter, compass, variometer, engine

// Ends of the scales.
inline constexpr double kAirspeedEndMps = 120, kClimbEndMps = 20;

// Angles in radians, clockwise from the top of the dial.
double airspeedNeedle(double metresPerSecond);  // 0 at the lower left (-135 degrees), the end at +135
struct AltimeterNeedles {
  double hundreds = 0, thousands = 0;  // one turn: 1000 m, 10 000 m; below the sea they turn back
};
AltimeterNeedles altimeterNeedles(double metres);  // [0, 2 pi)
double compassCard(double headingRad);             // of north, (-2 pi, 0]
double variometerNeedle(double metresPerSecond);  // 0 points left (-90 degrees), +-150 from there at the ends
double engineNeedle(double throttle);             // idle at -135, full at +135
// The horizon in the dial of attitude: how far it lies below the middle (shares of the radius, [-1, 1]) and
// how it is turned against the wings, (-pi, pi].
struct HorizonLine {
  double below = 0, turnRad = 0;
};
HorizonLine horizonLine(double pitchRad, double bankRad);

// `places`: the squares of the six dials, in their order.
void drawInstruments(const Interface& context, const InstrumentReadings& readings,
                     const std::array<ScreenRect, kInstruments>& places);

}  // namespace skydrop::ui
