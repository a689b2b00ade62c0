// Edges of what is drawn with one sample a pixel: where they are, and how much of a pixel beside one belongs to the other
// side. After morphological antialiasing (Reshetov, "Morphological antialiasing", 2009; Jimenez and others, "SMAA:
// enhanced subpixel morphological antialiasing", 2012), with edges found in depth alone.
#ifndef __cplusplus
#include "shared/guards.glsl"
#endif

CONST Real kStepBend = Real(0.5);    // of the step: how much of it surfaces that go on do not explain

// Whether one surface ends between two pixels whose depths differ by `step`: `bendBefore` and `bendAfter` are how much more
// or less that is than from the pixel before to the first and from the second to the next. `least`: of the
// step, (0, 1) of the greater of the two depths. Depths are reversed (near plane / distance), which makes them linear in the
// picture over a plane.
FN bool isStepBetween(Real step, Real least, Real bendBefore, Real bendAfter) {
  return abs(step) > least && min(abs(bendBefore), abs(bendAfter)) > kStepBend * abs(step);
}

// The same between the pixels a and b of four in a row. `leastShare`: of the greater depth.
FN bool isStep(Real before, Real a, Real b, Real after, Real leastShare) {
  Real step = b - a;
  return isStepBetween(step, leastShare * max(a, b), step - (a - before), step - (after - b));
}

// A run of steps between two rows of pixels stands for a line that crosses from one row to the other at its ends. `begin`
// and `end`: whether it leaves the run there to the first row (-1), to the second (1), or not (0). Of the pixels `at`
// [0, length) in the run: x: the share of the first row's pixel that belongs to the second row's side, y: the reverse.
// Each is at most 1/2.
FN Vec2 stepShares(Real at, Real length, Real begin, Real end) {
  Real middle = Real(0.5) * length;
  Real a0 = min(at, middle), b0 = min(at + Real(1.0), middle);
  Real a1 = max(at, middle), b1 = max(at + Real(1.0), middle);
  // Integrals of half a pixel that falls to nothing in the middle.
  Real first = Real(0.5) * ((b0 - a0) - (b0 * b0 - a0 * a0) / length);
  Real second = Real(0.5) * ((b1 * b1 - a1 * a1) / length - (b1 - a1));
  return Vec2(first * max(-begin, Real(0.0)) + second * max(-end, Real(0.0)),
              first * max(begin, Real(0.0)) + second * max(end, Real(0.0)));
}
