// What is thrown up from land and water flies, and what falls into water makes waves. SI units, y up.
#ifndef __cplusplus
#include "shared/guards.glsl"
#endif

CONST Real kGravityMps2 = Real(9.80665);

// (1 - (1 - exp(-x)) / x) / x for x >= 0; 1/2 at 0. The difference cancels for small x: there the series (9 terms,
// relative error 2e-7 up to 0.5).
FN Real oneMinusMeanOverX(Real x) {
  if (x < Real(0.5)) {
    Real s = Real(1.0) - x / Real(9.0);
    s = Real(1.0) - x / Real(8.0) * s;
    s = Real(1.0) - x / Real(7.0) * s;
    s = Real(1.0) - x / Real(6.0) * s;
    s = Real(1.0) - x / Real(5.0) * s;
    s = Real(1.0) - x / Real(4.0) * s;
    s = Real(1.0) - x / Real(3.0) * s;
    return Real(0.5) * s;
  }
  return (Real(1.0) - oneMinusExpOverX(x)) / x;
}

// The way of a particle, `seconds` after it left with a velocity, under drag in proportion to its speed through the air
// (1/s, >= 0) and a constant acceleration downwards (negative: what is warm rises). The solution of
// dv/dt = -drag (v - wind) - fall y, exact for any time.
FN Vec3 sprayWay(Vec3 velocity, Vec3 wind, Real drag, Real fall, Real seconds) {
  Real x = drag * seconds;
  return wind * seconds + (velocity - wind) * (seconds * oneMinusExpOverX(x)) -
         Vec3(Real(0.0), fall * seconds * seconds * oneMinusMeanOverX(x), Real(0.0));
}

// Its velocity then.
FN Vec3 sprayVelocity(Vec3 velocity, Vec3 wind, Real drag, Real fall, Real seconds) {
  Real x = drag * seconds;
  return wind + (velocity - wind) * exp(-x) - Vec3(Real(0.0), fall * seconds * oneMinusExpOverX(x), Real(0.0));
}

// The slope of the waves that a body of a radius makes as it falls into deep water, along the way out from there:
// Cauchy's and Poisson's waves of a point (Lamb, Hydrodynamics, 1932, section 255: phase g t^2 / 4 r, so that long waves
// run ahead), without those that are short beside the body. 1 is the steepest at the distance of a radius; it falls with
// the distance as theirs, and is at most 4. Any distance and time >= 0; 0 at both ends.
FN Real impactWaveSlope(Real distanceM, Real seconds, Real radiusM) {
  Real r = max(distanceM, Real(0.25) * radiusM);
  Real phase = Real(0.25) * kGravityMps2 * seconds * seconds / r;
  Real ka = min(phase / r * radiusM, Real(16.0));  // wave number times radius
  Real size = ka * exp(Real(1.0) - ka);
  return size * radiusM / r * sin(phase);
}
