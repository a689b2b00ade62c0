// A projectile with linear drag in long double: what integrators are compared with.
#pragma once

#include <cmath>

#include "skydrop/flight/environment.h"

namespace skydrop::stability {

struct Truth {
  long double x, y, vx, vy;
};

// v' = g - k v from (0, 0) in long double, by expm1 and, where that cancels, by series.
inline Truth projectile(long double vx, long double vy, long double k, long double t) {
  const long double g = flight::kGravity, z = k * t;
  const long double one = z > 0 ? -expm1l(-z) / k : t;  // (1 - exp(-kt)) / k
  const long double two = z > 0.01L ? (t - one) / k
                                    : t * t *
                                          (1 / 2.0L - z / 6 + z * z / 24 - z * z * z / 120 +
                                           z * z * z * z / 720 - z * z * z * z * z / 5040);
  return {vx * one, vy * one - g * two, vx * expl(-z), vy * expl(-z) - g * one};
}

}  // namespace skydrop::stability
