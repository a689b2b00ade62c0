// A flash of lightning as points of light, each spread over a length of its channel (core2: the square of that, m^2,
// above 0). Intensity in kcd, illuminance in klx, radiance in kcd/m^2. Has a C++ face of its own,
// include/skydrop/core/shared_flash.h.
#ifndef __cplusplus
#include "shared/guards.glsl"
#endif

// Illuminance per intensity on a surface with a unit normal; toLight: from the surface, m.
FN Real flashIlluminance(Vec3 toLight, Vec3 normal, Real core2) {
  Real square = dot(toLight, toLight) + core2;
  return max(dot(normal, toLight), Real(0.0)) / (square * sqrt(square));
}

// Integral of 1 / distance^2 to a light along a ray from the eye, 1/m: what air that scatters evenly, and hardly dims,
// sends towards the eye is this times intensity, scattering and 1 / (4 pi) (Sun, Ramamoorthi, Narasimhan and Nayar 2005,
// without extinction). toLight: from the eye; unit direction; length > 0, at most kFarMarker.
FN Real flashAirlight(Vec3 toLight, Vec3 direction, Real lengthM, Real core2) {
  Real along = dot(toLight, direction);
  Vec3 aside = toLight - direction * along;
  Real nearest = sqrt(dot(aside, aside) + core2);
  // The sum of the angles to both ends, as one: of opposite signs, behind the eye or beyond the end, two would cancel.
  return atan(nearest, (nearest * nearest + along * along) / lengthM - along) / nearest;
}

// Radiance per intensity of a thick cloud at a distance from a light within it. Nearly all light comes out, spread over
// the sphere around it and the more of it the nearer; what has wandered far has left the cloud on the way. Fitted to photons
// followed through slabs of 6 and 10 km: within 40 % out to three times the light's height above the base
// (tests/unit/lightning_test.cpp). heightM: of the light above the cloud's base, > 0.
CONST Real kFlashCloudGain = Real(3.3);
CONST Real kFlashReachShare = Real(1.45);  // of heightM: falls by e
FN Real flashCloudGlow(Real square, Real core2, Real heightM) {
  Real fading = exp(-sqrt(square) / (kFlashReachShare * heightM));
  return kFlashCloudGain * fading / (Real(3.14159265) * (square + core2));
}

// How far in pixels along a piece of a line, blurred by a Gaussian: from 0 to 1, so that consecutive pieces add up to
// one line without a joint. The logistic function is the Gaussian's integral within 0.01.
FN Real flashAlong(Real pixels, Real spread) {
  return Real(1.0) / (Real(1.0) + exp(clamp(-Real(1.702) * pixels / spread, Real(-60.0), Real(60.0))));
}

// Radiance that is written of a channel: on the way to a most, so that all pieces over a bright scene stay half floats.
FN Real flashAtMost(Real radiance, Real most) { return radiance / (Real(1.0) + radiance / most); }
