// How the earth is turned in space: precession, nutation, rotation; and where on it an observer stands. Of
// the almanac alone.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "skydrop/sky/almanac.h"

namespace skydrop::sky {

// Axes in space: x to the true equinox of date, z to the true pole of date.
struct Earth {
  double centuries = 0;    // Julian, of terrestrial time since J2000
  double nutationRad = 0;  // in longitude
  double meanObliquityRad = 0;
  double obliquityRad = 0;  // true
};
Earth earthAt(double days);

// Apparent sidereal time at Greenwich, degrees in [0, 360).
double greenwichSiderealDegrees(double days, const Earth& earth);

// The observer, and the rotation from the axes of date to those of the world.
struct Observer {
  glm::dvec3 positionKm{0};
  glm::dmat3 toWorld{1};
  double siderealDegrees = 0;
};
Observer observerAt(double days, const Earth& earth, const Place& place);

// Mean axes of J2000 to true axes of date.
glm::dmat3 precessionAndNutation(const Earth& earth);

// Ecliptic of date to its equator.
glm::dvec3 fromEcliptic(const glm::dvec3& ecliptic, double obliquityRad);

// In [0, 360).
double turned(double degrees);

}  // namespace skydrop::sky
