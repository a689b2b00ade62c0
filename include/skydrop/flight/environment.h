// Constants of the world that flies: the same everywhere, so that nothing flies differently in another
// valley.
#pragma once

namespace skydrop::flight {

inline constexpr double kGravity = 9.80665;   // m/s^2, standard gravity
inline constexpr double kAirDensity = 1.225;  // kg/m^3, at sea level, used at all heights

}  // namespace skydrop::flight
