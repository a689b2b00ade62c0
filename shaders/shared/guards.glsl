// Arithmetic that stays defined at its edges.
#ifndef __cplusplus
#include "shared/dialect.glsl"
#endif

FN Real saturate(Real x) { return clamp(x, Real(0.0), Real(1.0)); }

// x carried from [a, b] to [c, d], clamped to it. Equal bounds make a step: c below a, d from a on.
FN Real remapClamped(Real x, Real a, Real b, Real c, Real d) {
  Real width = b - a;
  Real t = abs(width) > Real(0.0) ? saturate((x - a) / width) : (x < a ? Real(0.0) : Real(1.0));
  return c + (d - c) * t;
}

FN Real squareRoot(Real x) { return sqrt(max(x, Real(0.0))); }

// v / |v|, or `fallback` (a unit vector) where v has no direction.
FN Vec3 directionOf(Vec3 v, Vec3 fallback) {
  Real square = dot(v, v);
  return square > Real(1e-30) ? v / sqrt(square) : fallback;
}

// (1 - exp(-x)) / x for x >= 0; 1 at 0. The quotient cancels for small x, and Mesa's exp is good to 3e-6 only, so
// below 0.5 the series is used (7 terms, relative error 2e-7); above it the error is below 5e-6.
FN Real oneMinusExpOverX(Real x) {
  if (x < Real(0.5)) {
    Real s = Real(1.0) - x / Real(7.0);
    s = Real(1.0) - x / Real(6.0) * s;
    s = Real(1.0) - x / Real(5.0) * s;
    s = Real(1.0) - x / Real(4.0) * s;
    s = Real(1.0) - x / Real(3.0) * s;
    return Real(1.0) - x / Real(2.0) * s;
  }
  return (Real(1.0) - exp(-x)) / x;
}

FN Vec3 oneMinusExpOverX3(Vec3 v) {
  return Vec3(oneMinusExpOverX(v.x), oneMinusExpOverX(v.y), oneMinusExpOverX(v.z));
}
