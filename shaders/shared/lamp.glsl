// Lamps as points of light: what a spot sends out at an angle, and the glare that a bright point makes in the eye.
// Intensity in kcd, illuminance in klx, radiance in kcd/m^2; angles in degrees where the name says so. Has a C++ face of
// its own, include/skydrop/core/shared_lamps.h.
#ifndef __cplusplus
#include "shared/guards.glsl"
#endif

// Nothing is nearer to a lamp than its lens, m.
CONST Real kLampLensM = Real(0.1);

// Share of a spot's peak intensity at an angle from its axis: half of it at half the beam's width, as the widths of
// sealed beams are given. Near the axis of narrow beams, 2 (1 - cosine) is the angle's square. 0 behind it.
// 2 (1 - cosine) is taken as the square of what lies between two unit vectors, `axis` and `ray`, both away from the spot:
// from the cosine a float has it within 6e-8 only, 1e-3 of the beam's edge at half a degree.
FN Real spotShare(Vec3 axis, Vec3 ray, Real halfAngleRad) {
  Vec3 between = ray - axis;
  Real square = dot(between, between) / (halfAngleRad * halfAngleRad);
  return dot(axis, ray) > Real(0.0) ? exp(-min(Real(0.693147) * square, Real(60.0))) : Real(0.0);
}

// Illuminance per intensity on a surface with a unit normal; toLamp: from the surface to the lamp, m.
FN Real lampIlluminance(Vec3 toLamp, Vec3 normal) {
  Real square = max(dot(toLamp, toLamp), kLampLensM * kLampLensM);
  return max(dot(normal, toLamp), Real(0.0)) / (square * sqrt(square));
}

// The same with a lamp that shines along a unit axis.
FN Real spotIlluminance(Vec3 toLamp, Vec3 normal, Vec3 axis, Real halfAngleRad) {
  Real distanceM = sqrt(max(dot(toLamp, toLamp), kLampLensM * kLampLensM));
  return lampIlluminance(toLamp, normal) * spotShare(axis, -toLamp / distanceM, halfAngleRad);
}

// Where the eye's own blur bounds the formula below, degrees.
CONST Real kGlareCoreDegrees = Real(0.15);

// Shape of the veil that light scattered in the eye lays around a point of light, 1/degree^2: Stiles and Holladay's law
// of disability glare (CIE 146, 2002) gives 10 times the illuminance at the eye times this. Shifted so that it ends at
// `reachDegrees`.
FN Real glareShape(Real degrees2, Real reachDegrees) {
  Real core = kGlareCoreDegrees * kGlareCoreDegrees;
  return max(Real(1.0) / (degrees2 + core) - Real(1.0) / (reachDegrees * reachDegrees + core), Real(0.0));
}
