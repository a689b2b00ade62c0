// Constants of the world that flies: the same everywhere, so that nothing flies differently in another
// valley.
#pragma once

namespace skydrop::flight {

inline constexpr double kGravity = 9.80665;   // m/s^2, standard gravity
inline constexpr double kAirDensity = 1.225;  // kg/m^3, at sea level, used up to kThinAirFrom

// Nothing begins higher than the ceiling (m), and no camera in the world is put there: land ends at 100 km
// and the air is drawn as if the earth were flat, so that from further up the land becomes a disc in
// darkness. The air thins below it, from kThinAirFrom (m) on by a factor e in kThinAirScale (m), so that no
// aircraft flies there either.
inline constexpr double kCeiling = 20000;
inline constexpr double kThinAirFrom = 15000;
inline constexpr double kThinAirScale = 1000;

}  // namespace skydrop::flight
