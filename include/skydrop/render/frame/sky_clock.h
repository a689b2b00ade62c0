// The clock and the place of the settings, as the almanac (skydrop/sky/almanac.h) is asked with them, whoever
// moves the sun. Pure functions, from any thread.
#pragma once

#include "skydrop/render/frame/render_settings.h"
#include "skydrop/sky/almanac.h"

namespace skydrop::render {

// Days since 2000-01-01T12:00:00Z at a simulated time.
double clockDays(const SunSettings& clock, double simulatedSeconds);
sky::Place placeOf(const SunSettings& clock);

}  // namespace skydrop::render
