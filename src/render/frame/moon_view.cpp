#include "render/frame/moon_view.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>

#include "skydrop/render/frame/sky_clock.h"
#include "skydrop/sky/almanac.h"
#include "skydrop/sky/refraction.h"

namespace skydrop::render {

MoonView moonView(const SunSettings& clock, double simulatedSeconds) {
  const double days = clockDays(clock, simulatedSeconds);
  const sky::Place place = placeOf(clock);
  const sky::Body moon = sky::moonAt(days, place), sun = sky::sunAt(days, place);
  const glm::dvec3 toMoon = sky::worldDirection(moon.horizontal);
  MoonView view;
  view.toSun =
      glm::normalize(sky::worldDirection(sun.horizontal) * sun.distanceKm - toMoon * moon.distanceKm);
  view.direction = sky::worldDirection(sky::refracted(moon.horizontal));
  view.radiusRad = glm::radians(moon.radiusDegrees);
  view.distanceKm = moon.distanceKm;
  view.phaseAngleDegrees = glm::degrees(std::acos(std::clamp(-glm::dot(view.toSun, toMoon), -1.0, 1.0)));
  // Its axis is 1.5 degrees from the pole of the ecliptic (Cassini's laws); libration is left out.
  const double obliquity = glm::radians(23.4393);
  const glm::dvec3 pole =
      sky::j2000ToWorld(days, place) * glm::dvec3(0, -std::sin(obliquity), std::cos(obliquity));
  view.north = glm::normalize(pole - view.direction * glm::dot(pole, view.direction));
  return view;
}

const MoonView& MoonOfFrame::at(const SunSettings& clock, double simulatedSeconds) {
  if (made_ > 0 && clock_ == clock && seconds_ == simulatedSeconds) return view_;
  view_ = moonView(clock, simulatedSeconds);
  clock_ = clock;
  seconds_ = simulatedSeconds;
  ++made_;
  return view_;
}

MoonView moonOf(MoonOfFrame* frame, const SunSettings& clock, double simulatedSeconds) {
  return frame ? frame->at(clock, simulatedSeconds) : moonView(clock, simulatedSeconds);
}

}  // namespace skydrop::render
