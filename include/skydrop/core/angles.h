// Angles that go round. Pure; any thread; the same bits on every machine.
#pragma once

#include <cmath>

namespace skydrop::core {

// The same direction within [0, 360), never -0; of any finite angle, exact for angles that are not negative.
// (x - 360 floor(x / 360) is off by turns beyond 1e17, and lies below 0 where the quotient is rounded to -0.)
inline double wrappedDegrees(double degrees) {
  const double part = std::fmod(degrees, 360.0);  // exact
  const double within = part < 0 ? part + 360 : part;
  return within < 360 ? within + 0.0 : 0;  // -1e-20 is rounded up to 360
}

}  // namespace skydrop::core
