// Clouds as sheets without thickness: from one channel of noise in [0, 1] to an opacity and to the light that a sheet
// sends to the eye. Source of the curve: Tarantilis, "Simulating clouds with procedural texturing techniques using the
// GPU", 2004, chapter III (clamping and exponentiation); what it leaves to one flat colour is lit here.
#ifndef __cplusplus
#include "shared/guards.glsl"
#include "shared/cloud_light.glsl"
#endif

// Steps of a channel of eight bits, in which densities and exponents count: noise that is 1 / 255 further above the
// cutoff lets `density` times as much light through.
CONST Real kSheetSteps = Real(255.0);

// Optical depth of a sheet by noise above the cutoff: 1 - density^(255 (noise - cutoff)) is 1 - exp(-depth).
// density in (0, 1).
FN Real sheetDepthPerNoise(Real density) { return -kSheetSteps * log(density); }

FN Real sheetDepth(Real noise, Real cutoff, Real depthPerNoise) { return max(noise - cutoff, Real(0.0)) * depthPerNoise; }

// The clamped and exponentiated noise: 0 up to the cutoff.
FN Real sheetOpacity(Real noise, Real cutoff, Real depthPerNoise) {
  return stepOpacity(sheetDepth(noise, cutoff, depthPerNoise));
}

// Share of a sheet's area that is cloud, and the mean optical depth of that share.
struct SheetCover {
  Real share;
  Real depth;
};

// What a pixel sees that covers noise of this mean and standard deviation (spread), taken as logistic: a mean taken
// before the curve would let all clouds far away vanish, because it falls below the cutoff. spread 0: the curve itself.
FN SheetCover sheetCover(Real noise, Real spread, Real cutoff, Real depthPerNoise) {
  Real wide = max(spread, Real(1e-4)) * Real(0.5513);  // sqrt(3) / pi: the scale of a logistic distribution
  Real x = (noise - cutoff) / wide;
  Real e = exp(-abs(x));
  SheetCover cover;
  cover.share = (x >= Real(0.0) ? Real(1.0) : e) / (Real(1.0) + e);
  // wide * log(1 + exp(x)), without overflow.
  Real above = max(noise - cutoff, Real(0.0)) + wide * log(Real(1.0) + e);
  // Far below the cutoff the quotient tends to the scale itself, where a float's 1 + e forgets e.
  cover.depth = depthPerNoise * (x < Real(-8.0) ? wide : above / cover.share);
  return cover;
}

// Of a sheet seen at a slant: path is how much longer the way through it is than straight through, at least 1.
FN Real sheetCoverOpacity(SheetCover cover, Real path) { return cover.share * stepOpacity(cover.depth * path); }

// The longest way through a sheet against the way straight through: sheets stand for layers that are not infinitely wide.
FN Real sheetPath(Real cosine) { return Real(1.0) / max(abs(cosine), Real(0.3)); }

// How fast a sheet drifts at a height (m), as a share of the wind: more the lower it is, 2 at the ground, 1 at 1000 m.
FN Real sheetDriftShare(Real heightM) { return Real(2.0) / (Real(1.0) + max(heightM, Real(0.0)) / Real(1000.0)); }

// The dome. Where its clouds are taken to be for the air before them and the sun on them, m above the sea.
CONST Real kDomeHeightM = Real(7000.0);
// A sheet seen from below is denser towards the horizon by 1 / sin(elevation), which this keeps finite: the earth's
// curvature does, which lets a sheet 7 km up end 300 km away.
CONST Real kDomeCurve = Real(0.12);
// Where a direction above the horizon meets the noise: on a unit hemisphere (flatness 0), or on a level sheet at height 1
// (flatness 1).
FN Vec3 domePlace(Vec3 direction, Real flatness) {
  Real sheet = (Real(1.0) + kDomeCurve) / (max(direction.y, Real(0.0)) + kDomeCurve);
  return direction * mix(Real(1.0), sheet, flatness);
}

// A rotation that turns the vertical to (1, sqrt(2), sqrt(3)) / sqrt(6), to which no whole numbers are orthogonal: the
// level sheet cuts the volume so that no two of its places are a period apart, and never repeats.
FN Vec3 domeTurn(Vec3 v) {
  return Vec3(Real(0.8164966), Real(-0.5773503), Real(0.0)) * v.x +
         Vec3(Real(0.4082483), Real(0.5773503), Real(0.7071068)) * v.y +
         Vec3(Real(0.4082483), Real(0.5773503), Real(-0.7071068)) * v.z;
}

// How far away the clouds of a direction are, m, from an eye at a height.
FN Real domeDistance(Real sine, Real eyeHeightM) {
  return max(kDomeHeightM - eyeHeightM, Real(1000.0)) * (Real(1.0) + kDomeCurve) / (max(sine, Real(0.0)) + kDomeCurve);
}
