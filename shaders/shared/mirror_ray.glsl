// Rays that water mirrors, followed through the depths of a picture.
#ifndef __cplusplus
#include "shared/guards.glsl"
#endif

// How far along the ray a place is, m: closer near its foot; the last of all is at the end.
FN Real mirrorStep(int index, int count, Real reachM) {
  Real t = Real(index) / Real(max(count, 1));
  return reachM * t * t * t;
}

// Slopes for which rays are followed, in standard deviations: of equal shares of a normal distribution (quantiles within
// .01), at a place in each that differs between four neighbours, [0, 4).
FN Real mirrorQuantile(int index, int count, int neighbour) {
  Real share = (Real(index) + Real(0.125) + Real(0.25) * Real(neighbour)) / Real(max(count, 1));
  // Tukey's lambda distribution (Tukey 1960) is the normal one within .01 up to two standard deviations.
  return (pow(share, Real(0.14)) - pow(Real(1.0) - share, Real(0.14))) * Real(4.91);
}

// How much of a ray belongs to what it met: all where the depth of the picture is that of the ray; none where the ray runs
// far behind it, and towards the picture's edges. behindM of what it met; stepM that led there; x, y in [0, 1].
FN Real mirrorShare(Real behindM, Real stepM, Real x, Real y) {
  Real close = saturate(Real(2.0) - Real(8.0) * behindM / max(stepM, Real(0.5)));
  Real edge = min(min(x, Real(1.0) - x), min(y, Real(1.0) - y));
  return close * saturate(edge * Real(16.0));
}
