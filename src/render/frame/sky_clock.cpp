#include "skydrop/render/frame/sky_clock.h"

namespace skydrop::render {

double clockDays(const SunSettings& clock, double simulatedSeconds) {
  const double seconds = clock.shiftDays * 86400 + clock.shiftHours * 3600 + clock.offsetSeconds +
                         simulatedSeconds * clock.timeScale;
  return sky::daysSinceJ2000({clock.utcMs}, seconds);
}

sky::Place placeOf(const SunSettings& clock) {
  return {.latitudeDegrees = clock.latitudeDegrees, .longitudeDegrees = clock.longitudeDegrees};
}

}  // namespace skydrop::render
