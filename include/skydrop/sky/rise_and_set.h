// When sun and moon rise, culminate and set. Pure functions, from any thread; the same bits on every machine.
#pragma once

#include <optional>

#include "skydrop/sky/almanac.h"

namespace skydrop::sky {

enum class Horizon { risesAndSets, staysAbove, staysBelow };

// The first of each after a time, as days like that time. A body rises and sets when the upper edge of its
// disc appears at the level horizon of the sea, 34 minutes of arc of refraction included. What does not
// happen within two days (midnight sun, polar night, the moon at high latitudes) is left out.
struct Events {
  std::optional<double> rise, set;
  std::optional<double> transit;            // highest in the sky, or lowest above the pole: hour angle 0
  Horizon horizon = Horizon::risesAndSets;  // of these two days
};

Events sunEvents(double days, const Place& place);
Events moonEvents(double days, const Place& place);

// To a tenth of a second of what the positions give. Their error moves a rise by 15 seconds of time for each
// hundredth of a degree in elevation at the slowest (see docs/sky.md); the air moves it by minutes.
inline constexpr double kEventToleranceDays = 0.1 / 86400;

}  // namespace skydrop::sky
