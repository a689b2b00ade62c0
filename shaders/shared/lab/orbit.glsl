// A camera that orbits a place, and the colours of quantities.
#ifndef __cplusplus
#include "shared/guards.glsl"
#endif

struct Orbit {
  Vec3 place;
  Vec3 ahead;
  Vec3 right;
  Vec3 above;
};

// Angles in radians; the elevation within +-pi/2 exclusive. `distance` from `middle`.
FN Orbit make_orbit(Vec3 middle, Real azimuth, Real elevation, Real distance) {
  Real c = cos(elevation);
  Orbit orbit;
  orbit.ahead = Vec3(-c * sin(azimuth), -sin(elevation), -c * cos(azimuth));
  orbit.right = Vec3(cos(azimuth), Real(0.0), -sin(azimuth));
  Real s = sin(elevation);
  orbit.above = Vec3(-s * sin(azimuth), c, -s * cos(azimuth));
  orbit.place = middle - orbit.ahead * distance;
  return orbit;
}

// The ray through a place of the picture, whose height is from -1 to 1. `zoom` is the focal length in half heights.
FN Vec3 orbitRay(Orbit orbit, Vec2 at, Real zoom) {
  return directionOf(orbit.ahead * zoom + orbit.right * at.x + orbit.above * at.y, orbit.ahead);
}

// From dark blue at 0 over green and yellow to red at 1, linear light.
FN Vec3 heatColor(Real x) {
  Real t = saturate(x);
  return Vec3(saturate(Real(1.5) - abs(Real(4.0) * t - Real(3.0))) + saturate(t * Real(4.0) - Real(3.5)),
              saturate(Real(1.5) - abs(Real(4.0) * t - Real(2.0))), saturate(Real(1.5) - abs(Real(4.0) * t - Real(1.0))));
}
