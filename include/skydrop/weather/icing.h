// Ice on the wing: how much of it there is, [0, 1], where 1 takes what kIceLiftLoss says. Pure, any thread.
#pragma once

namespace skydrop::weather {

inline constexpr double kIceLiftLoss = 0.3;  // of the lift, at most
inline constexpr double kIceDragGain = 0.6;  // of the drag, at most

// What the aircraft flies in.
struct IcingAir {
  double temperatureC = 15;
  double cloudDensity = 0;  // [0, 1], of supercooled droplets
  double rain = 0;          // mm/h; freezes on the wing when it is colder than 0
};

// The ice after so many seconds. It grows in cold cloud, fastest at -7 degrees (a minute and a half to full
// in dense cloud) and no more below -25, where clouds are of ice (FAA AC 91-74B, 2015; Jeck 2002), and in
// rain that freezes; it melts above 0, at 10 degrees in a minute, and sublimates in clear cold air in half an
// hour. `rate` scales the growth. The approach is exponential, so that the result does not depend on how the
// time is cut.
double iceAfter(double ice, const IcingAir& air, double rate, double seconds);

}  // namespace skydrop::weather
