// What of rain and snow lies on the ground, with a memory: it fills while they fall and dries or melts when
// they end. A pure function of the weather's moment and place, which looks back in time itself: no history is
// kept, so a jump in time, a replay and a picture at a time all find the same land.
//
//   dw/dt = r / c (1 - w) - w / tau,   w in [0, 1],
//
// with r the rate on the ground (mm/h), c the film that wets all of it (mm) and tau the time in which it
// dries: the film over the evaporation of Penman (1948), 0.26 (1 + 0.54 u) (e_s - e) mm a day of wind u (m/s)
// and the air's lack of vapour (hPa), which follows from temperature and the height of the base (Espy 1841);
// in rain hardly anything dries. Between knots the rate is even, and the equation is solved exactly; they lie
// at multiples of 30 s near the moment and at steps that double on the way back.
#pragma once

#include <glm/vec2.hpp>

#include "skydrop/weather/moment.h"

namespace skydrop::weather {

struct LyingWater {
  double wet = 0;   // share of the ground that is, [0, 1]
  double snow = 0;  // how much of it snow covers above the snow line, [0, 1]
};

inline constexpr double kFilmMm = 0.2;     // water that wets bare ground and plants
inline constexpr double kSnowCoverMm = 1;  // water of the snow that hides the ground
inline constexpr int kLyingSteps = 16;     // at least, of each length
inline constexpr double kLyingTimes = 6;   // times as long as it takes to go: e^-6 of what lay is left

// Height above the sea from which on snow lies, m: half a degree.
double snowLineM(const State& state);

// s, [300, 21600]: after which e^-1 of a film is left where nothing falls; of snow s, [1800, 86400]: below
// freezing it goes by vapour alone, above it melts by a day's degrees.
double dryingSeconds(const State& state);
double meltingSeconds(const State& state);

// At a place, x east, z south, m. Only where there is weather. stepsALevel: kLyingSteps but for who measures.
LyingWater lyingWater(const Moment& moment, const glm::dvec2& xz, int stepsALevel = kLyingSteps);

// Whether water or snow falls anywhere, ever: else nothing lies anywhere, and nobody need look back.
bool everFalls(const Moment& moment);

}  // namespace skydrop::weather
