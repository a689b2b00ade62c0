// Arithmetic that stays defined at its edges.
#ifndef __cplusplus
#include "shared/dialect.glsl"
#endif

FN Real saturate(Real x) { return clamp(x, Real(0.0), Real(1.0)); }

// x carried from [a, b] to [c, d], clamped to it, both ends exact. Equal bounds make a step: c below a, d from a on.
FN Real remapClamped(Real x, Real a, Real b, Real c, Real d) {
  Real width = b - a;
  Real t = abs(width) > Real(0.0) ? saturate((x - a) / width) : (x < a ? Real(0.0) : Real(1.0));
  return c * (Real(1.0) - t) + d * t;  // c + (d - c) t is 0 for c = 1e30, d = 1, t = 1
}

FN Real squareRoot(Real x) { return sqrt(max(x, Real(0.0))); }

// x - floor(x) within [0, 1): the difference is rounded up to 1 where x is a little below 0.
FN Real fractionOf(Real x) {
  Real part = x - floor(x);
  return part < Real(1.0) ? part : Real(0.0);
}

// v / |v|, or `fallback` (a unit vector) where v has no direction: no component beyond 2^-100, or one not finite.
FN Vec3 directionOf(Vec3 v, Vec3 fallback) {
  Real square = dot(v, v);
  if (square > Real(1e-30) && square < Real(1e30)) return v / sqrt(square);
  // The square of what is shorter than 1e-19 or longer than 1e19 is no float: the longest component goes first.
  Real longest = max(abs(v.x), max(abs(v.y), abs(v.z)));
  if (!(longest > Real(7.888609052210118e-31) && longest < Real(3e38))) return fallback;
  Vec3 scaled = v / longest;
  return scaled / sqrt(dot(scaled, scaled));
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
